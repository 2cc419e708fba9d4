#include "generator/ply.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace capcon::scenes {

namespace {
void put(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<char>(word >> 8 * k & 255));
}
}  // namespace

std::string ply_bytes(const Mesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.triangles.size());
  bytes.reserve(bytes.size() + 12 * mesh.positions.size() + 13 * mesh.triangles.size());
  for (const Vec3& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(p[k])));
  }
  for (const glm::uvec3& t : mesh.triangles) {
    bytes.push_back(3);
    for (int k = 0; k < 3; ++k) put(bytes, t[k]);
  }
  return bytes;
}

}  // namespace capcon::scenes
