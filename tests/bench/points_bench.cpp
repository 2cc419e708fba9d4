// Rows of speed and quality of the point optimisers: capcon_points_bench [rows...], rows are the names it
// prints. Seconds are of the processor over all threads; medians over the repeats, each with a seed of its
// own.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "points/ccvt.h"
#include "points/measure.h"
#include "points/transport.h"

namespace {

using namespace capcon;

double cpu_seconds() {
  std::timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Row {
  const char* name;
  std::uint32_t n, capacity;
  bool finish;
  int repeats;
  double energy_goal, cpu_goal;  ///< 0: none
};

const Row kRows[] = {
    {"swaps-1024-64", 1024, 64, false, 9, 0, 0},
    {"swaps-1024-256", 1024, 256, false, 9, 0, 0},
    {"swaps-1024-1024", 1024, 1024, false, 9, 1.0483, 0.25},
    {"swaps-4096-64", 4096, 64, false, 5, 0, 0},
    {"swaps-4096-256", 4096, 256, false, 5, 0, 0},
    {"swaps-4096-1024", 4096, 1024, false, 3, 0, 1.3},
    {"swaps-65536-64", 65536, 64, false, 1, 0, 0},
    {"swaps-65536-256", 65536, 256, false, 1, 0, 0},
    {"finish-1024", 1024, 64, true, 9, 1.010, 0.6},
    {"finish-4096", 4096, 64, true, 5, 0, 3},
    {"finish-65536", 65536, 64, true, 1, 0, 0},
    {"swaps-1048576-64", 1048576, 64, false, 1, 0, 0},
};

/// Later row over earlier: seconds per point may grow by at most so much.
struct Growth {
  const char* from;
  const char* to;
};
const Growth kGrowths[] = {{"swaps-4096-64", "swaps-65536-64"},
                           {"swaps-4096-256", "swaps-65536-256"},
                           {"finish-4096", "finish-65536"}};
constexpr double kGrowthGoal = 1.4;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

const char* verdict(bool has_goal, bool met) {
  return !has_goal ? "" : met ? " met" : " MISSED";
}

/// Runs a row and prints it; returns processor seconds a point.
double run(const Row& row) {
  std::vector<double> cpu, wall, energy, transport;
  for (int r = 0; r < row.repeats; ++r) {
    CcvtOptions options;
    options.sites = row.n;
    options.capacity = row.capacity;
    options.finish = row.finish;
    options.seed = static_cast<std::uint64_t>(r) + 1;
    const double cpu_start = cpu_seconds(), wall_start = wall_seconds();
    const Points points = ccvt(options).points;
    cpu.push_back(cpu_seconds() - cpu_start);
    wall.push_back(wall_seconds() - wall_start);
    double sum = 0;
    for (const VoronoiCell& cell : voronoi_cells(points)) sum += cell.second_moment;
    energy.push_back(row.n * sum / kHexagonEnergy);
    transport.push_back(transport_energy(points));
  }
  const double seconds = median(cpu), e_ot = median(transport);
  fmt::print(
      "{:<18} cpu {:8.3f} s (least {:.3f}){:<7} wall {:8.3f} s  {:6.1f} us/point  E {:.4f}  E_ot {:.4f}{}\n",
      row.name, seconds, *std::min_element(cpu.begin(), cpu.end()),
      verdict(row.cpu_goal > 0, seconds <= row.cpu_goal), median(wall), 1e6 * seconds / row.n, median(energy),
      e_ot, verdict(row.energy_goal > 0, e_ot <= row.energy_goal));
  std::fflush(stdout);
  return seconds / row.n;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> wanted(words + 1, words + count);
  fmt::print("{} threads; medians\n", thread_count());
  std::map<std::string, double> per_point;
  for (const Row& row : kRows) {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), row.name) != wanted.end())
      per_point[row.name] = run(row);
  }
  for (const Growth& growth : kGrowths) {
    if (!per_point.count(growth.from) || !per_point.count(growth.to)) continue;
    const double ratio = per_point[growth.to] / per_point[growth.from];
    fmt::print("seconds per point, {} to {}: x {:.2f}{}\n", growth.from, growth.to, ratio,
               verdict(true, ratio <= kGrowthGoal));
  }
}
