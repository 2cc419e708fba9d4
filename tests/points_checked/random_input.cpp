#include "points_checked/random_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/hash.h"
#include "points/generators.h"

namespace capcon {
namespace {

enum Stream : std::uint64_t { kChoice = 0x696e7661, kPlace };
constexpr double kBelowOne = 1 - 0x1p-53;
constexpr int kTasks = 10, kStarts = 12, kMasses = 11;
const char* const kTaskNames[kTasks] = {"cells",     "ccvt",      "region", "cell swaps", "near swaps",
                                        "partition", "transport", "fpo",    "lloyd",      "measure"};
const char* const kStartNames[kStarts] = {"random", "one place", "row",   "column", "diagonal", "seam",
                                          "grid",   "lattice",   "twins", "tight",  "touching", "one apart"};
const char* const kMassNames[kMasses] = {"even", "contrast 1e12", "one texel", "half",  "line", "board",
                                         "tiny", "huge",          "1 x N",     "N x 1", "1 x 1"};

}  // namespace

RandomInput::RandomInput(std::uint64_t which) : number(which) {
  const auto pick = [&](std::uint64_t k, std::uint64_t count) { return mix64(which, kChoice, k) % count; };
  // Cheap tasks more often than dear ones.
  constexpr std::pair<Task, int> kShares[] = {
      {Task::kCells, 9},     {Task::kCcvt, 6},      {Task::kRegion, 6}, {Task::kCellSwaps, 6},
      {Task::kNearSwaps, 3}, {Task::kPartition, 4}, {Task::kFpo, 2},    {Task::kMeasure, 4},
      {Task::kTransport, 1}, {Task::kLloyd, 1}};
  std::uint64_t share = pick(0, 42);
  for (const auto& [candidate, parts] : kShares) {
    task = candidate;
    if (share < static_cast<std::uint64_t>(parts)) break;
    share -= static_cast<std::uint64_t>(parts);
  }
  start = static_cast<Start>(pick(1, kStarts));
  mass = static_cast<Mass>(pick(2, kMasses));
  domain = static_cast<Domain>(pick(3, 3));
  constexpr std::uint32_t kCounts[] = {1, 2, 3, 4, 5, 7, 8, 13, 16, 31, 37, 64};
  // Small ones more often, up to 64.
  const auto small = [&](std::uint64_t k) {
    return static_cast<std::uint32_t>(1 + (pick(k, 64) * pick(k + 20, 64) + 32) / 63);
  };
  n = pick(4, 2) == 0 ? kCounts[pick(5, std::size(kCounts))] : small(5);
  capacity = pick(6, 4) == 0 ? 1 : small(7);
}

double RandomInput::u(std::uint64_t k) const {
  return uniform64(number, kPlace, k);
}

Points RandomInput::places(std::uint32_t count) const {
  Points points(count);
  const glm::dvec2 one(u(0), u(1));
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
  const Points lattice = start == Start::kLattice ? generate("lattice", {count}) : Points();
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec2 random(u(2 + 2 * i), u(3 + 2 * i));
    const double edges[] = {0, kBelowOne, 0.5, 0x1p-60, 0x1p-1074};
    glm::dvec2& p = points[i];
    switch (start) {
      case Start::kRandom:
        p = random;
        break;
      case Start::kOnePlace:
        p = one;
        break;
      case Start::kRow:
        p = {random.x, one.y};
        break;
      case Start::kColumn:
        p = {one.x, double(i) / count};
        break;
      case Start::kDiagonal:
        p = glm::dvec2(double(i) / count);
        break;
      case Start::kSeam:
        p = {edges[int(5 * random.x)], edges[int(5 * random.y)]};
        break;
      case Start::kGrid:
        p = {double(i % side) / side, double(i / side) / side};
        break;
      case Start::kLattice:
        p = lattice[i];
        break;
      case Start::kTwins:
        p = {int(3 * random.x) / 3.0, int(2 * random.y) / 2.0};
        break;
      case Start::kTight:
        p = one + 1e-9 * random;
        break;
      case Start::kTouching:
        p = one + 0x1p-52 * glm::dvec2(int(3 * random.x), int(3 * random.y));
        break;
      case Start::kOneApart:
        p = i == 0 ? random : one;
        break;
    }
    p = {std::min(p.x, kBelowOne), std::min(p.y, kBelowOne)};
  }
  return points;
}

Region RandomInput::region() const {
  Region region{domain, nullptr};
  if (mass == Mass::kNone) return region;
  std::uint32_t w = 16, h = 16;
  if (mass == Mass::kWide) w = 61, h = 1;
  if (mass == Mass::kTall) w = 1, h = 61;
  if (mass == Mass::kOne) w = h = 1;
  std::vector<double> values(w * h);
  const auto special = static_cast<std::uint32_t>(u(1000) * w * h);
  const std::uint32_t last = 8 * 16 + 8;  // in the disk too
  for (std::uint32_t i = 0; i < w * h; ++i) {
    const std::uint32_t x = i % w, y = i / w;
    double& v = values[i];
    switch (mass) {
      case Mass::kContrast:
        v = u(1001 + i) < 0.05 ? 1e12 : 1;
        break;
      case Mass::kOneTexel:
        v = i == (domain == Domain::kDisk ? last : special);
        break;
      case Mass::kHalf:
        v = special % 2 == 0 ? x < 8 : y >= 8;
        break;
      case Mass::kLine:
        v = (special % 2 == 0 ? x : y) == 8 ? 1 : 1e-12 * (special % 3);
        break;
      case Mass::kBoard:
        v = (x + y) % 2;
        break;
      case Mass::kTiny:
        v = 0x1p-1074 * int(4 * u(1001 + i)) + (i == last ? 0x1p-1074 : 0);
        break;
      case Mass::kHuge:
        v = 1e300 * (1 + 1e8 * u(1001 + i));
        break;
      default:
        v = 0.1 + u(1001 + i);
    }
  }
  region.density = std::make_shared<Density>(w, h, std::move(values));
  return region;
}

std::string RandomInput::words() const {
  constexpr const char* kDomains[] = {"torus", "square", "disk"};
  return fmt::format("input {}: {}, n {}, capacity {}, start {}, density {}, {}", number,
                     kTaskNames[static_cast<int>(task)], n, capacity, kStartNames[static_cast<int>(start)],
                     kMassNames[static_cast<int>(mass)], kDomains[static_cast<int>(domain)]);
}

}  // namespace capcon
