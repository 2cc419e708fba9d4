#include "generator/ply.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace capcon::scenes {

namespace {
void put(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<char>(word >> 8 * k & 255));
}
void put(std::string& bytes, const Vec3& v) {
  for (int k = 0; k < 3; ++k) put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(v[k])));
}
}  // namespace

std::string ply_bytes(const Mesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\n{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(),
      mesh.normals.empty() ? "" : "property float nx\nproperty float ny\nproperty float nz\n",
      mesh.triangles.size());
  bytes.reserve(bytes.size() + 24 * mesh.positions.size() + 13 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    put(bytes, mesh.positions[i]);
    if (!mesh.normals.empty()) put(bytes, mesh.normals[i]);
  }
  for (const glm::uvec3& t : mesh.triangles) {
    bytes.push_back(3);
    for (int k = 0; k < 3; ++k) put(bytes, t[k]);
  }
  return bytes;
}

}  // namespace capcon::scenes
