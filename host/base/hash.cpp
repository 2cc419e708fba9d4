#include "base/hash.h"

namespace capcon {

std::array<std::uint32_t, 4> pcg4d(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t w) {
  x = x * 1664525u + 1013904223u;
  y = y * 1664525u + 1013904223u;
  z = z * 1664525u + 1013904223u;
  w = w * 1664525u + 1013904223u;
  const auto stir = [&] {
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
  };
  stir();
  x ^= x >> 16;
  y ^= y >> 16;
  z ^= z >> 16;
  w ^= w >> 16;
  stir();
  return {x, y, z, w};
}

namespace {
std::uint64_t splitmix_finaliser(std::uint64_t v) {
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ull;
}  // namespace

std::uint64_t mix64(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  const std::uint64_t key = splitmix_finaliser(seed + kGolden * (2 * stream + 1));
  return splitmix_finaliser(splitmix_finaliser(key + kGolden * (counter + 1)));
}

double uniform64(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  return static_cast<double>(mix64(seed, stream, counter) >> 11) * 0x1p-53;
}

std::uint64_t fnv1a64(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const unsigned char c : bytes) hash = (hash ^ c) * 0x100000001b3ull;
  return hash;
}

}  // namespace capcon
