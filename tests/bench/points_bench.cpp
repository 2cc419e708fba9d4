// Rows of speed and quality of the point optimisers, with the goals that they are held to:
//
//   points_bench [--json] [--quick] [rows...]     rows are the names it prints; --quick leaves out long ones
//   points_bench invariants [COUNT]               random inputs with every step checked:
//   points_checked_bench.cpp
//
// Seconds are of the processor over all threads; medians over the repeats, each with a seed of its own. Every
// figure of quality is evaluated from the points alone, by code that the optimisers do not use. Growth rows
// run their two sizes in turns.

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "points/ccvt.h"
#include "points/fpo.h"
#include "points/generators.h"
#include "points/measure.h"
#include "points/partition.h"
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

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A figure, and the most or least that it should be.
struct Figure {
  std::string name;
  double value = 0;
  double goal = 0;
  enum Sense { kNone, kAtMost, kAtLeast } sense = kNone;

  bool met() const { return sense == kAtLeast ? value >= goal : sense == kNone || value <= goal; }
};

/// Prints figures as they come, and gathers them.
class Report {
 public:
  explicit Report(bool json) : json_(json) {}
  void row(const std::string& name, const std::vector<Figure>& figures) {
    std::string line = fmt::format("{:<22}", name);
    nlohmann::ordered_json entry = {{"row", name}};
    for (const Figure& f : figures) {
      line += fmt::format("  {} {:.5g}", f.name, f.value);
      entry[f.name] = {{"value", f.value}};
      if (f.sense == Figure::kNone) continue;
      const char* verdict = f.met() ? "met" : "MISSED";
      line += fmt::format(" ({} {:g}: {})", f.sense == Figure::kAtMost ? "<=" : ">=", f.goal, verdict);
      entry[f.name]["goal"] = f.goal;
      entry[f.name]["met"] = f.met();
      missed_ += !f.met();
    }
    rows_.push_back(entry);
    if (!json_) fmt::print("{}\n", line);
    std::fflush(stdout);
  }
  int end() const {
    if (json_)
      fmt::print("{}\n", nlohmann::ordered_json{{"threads", thread_count()}, {"rows", rows_}}.dump(1));
    else
      fmt::print("{} figures missed\n", missed_);
    return missed_ > 0 ? 1 : 0;
  }

 private:
  bool json_;
  int missed_ = 0;
  nlohmann::ordered_json rows_ = nlohmann::ordered_json::array();
};

/// Processor and wall seconds of a task.
struct Clocked {
  double cpu = 0, wall = 0;
};
Clocked clocked(const std::function<void()>& task) {
  const double cpu = cpu_seconds(), wall = wall_seconds();
  task();
  return {cpu_seconds() - cpu, wall_seconds() - wall};
}

Points ccvt_points(std::uint32_t n, std::uint32_t capacity, bool finish, std::uint64_t seed) {
  CcvtOptions options;
  options.sites = n;
  options.capacity = capacity;
  options.finish = finish;
  options.seed = seed;
  return ccvt(options).points;
}

struct CcvtRow {
  const char* name;
  std::uint32_t n, capacity;
  bool finish;
  int repeats;
  double energy_goal, cpu_goal;  ///< 0: none
  bool is_long = false;
};
const CcvtRow kCcvtRows[] = {
    {"swaps-1024-64", 1024, 64, false, 9, 0, 0},
    {"swaps-1024-256", 1024, 256, false, 9, 0, 0},
    {"swaps-1024-1024", 1024, 1024, false, 21, 1.0483, 0.25},
    {"swaps-4096-1024", 4096, 1024, false, 5, 0, 1.3},
    {"finish-1024", 1024, 64, true, 21, 1.010, 0.6},
    {"finish-4096", 4096, 64, true, 5, 0, 3},
    {"million", 1048576, 64, false, 1, 0, 0, true},
};

void run(const CcvtRow& row, Report& report) {
  std::vector<double> cpu, wall, energies;
  for (int r = 0; r < row.repeats; ++r) {
    Points points;
    const Clocked time = clocked(
        [&] { points = ccvt_points(row.n, row.capacity, row.finish, static_cast<std::uint64_t>(r) + 1); });
    cpu.push_back(time.cpu);
    wall.push_back(time.wall);
    if (row.is_long) {
      rusage usage{};
      ::getrusage(RUSAGE_SELF, &usage);
      const double gib = static_cast<double>(usage.ru_maxrss) / (1 << 20);
      energies.push_back(measure(points).energy);
      report.row(row.name, {{"cpu_s", time.cpu},
                            {"wall_s", time.wall},
                            {"peak_gib", gib, 4, Figure::kAtMost},
                            {"energy", energies.back()}});
      return;
    }
    energies.push_back(transport_energy(points));
  }
  const auto sense = [](double goal) { return goal > 0 ? Figure::kAtMost : Figure::kNone; };
  report.row(row.name, {{"cpu_s", median(cpu), row.cpu_goal, sense(row.cpu_goal)},
                        {"wall_s", median(wall)},
                        {"us_a_point", 1e6 * median(cpu) / row.n},
                        {"e_ot", median(energies)},
                        {"e_ot_worst", *std::max_element(energies.begin(), energies.end()), row.energy_goal,
                         sense(row.energy_goal)}});
}

/// Processor seconds a point may grow by 1.4 from 4096 points to 65,536.
struct GrowthRow {
  const char* name;
  std::uint32_t capacity;
  bool finish;
};
const GrowthRow kGrowthRows[] = {
    {"growth-swaps-64", 64, false},
    {"growth-swaps-1024", 1024, false},
    {"growth-finish", 64, true},
};

void run(const GrowthRow& row, Report& report) {
  constexpr std::uint32_t kFew = 4096, kMany = 65536;
  const auto seconds = [&](std::uint32_t n, std::uint64_t seed) {
    ::malloc_trim(0);  // small sets too pay for fresh memory, as in a process of their own
    return clocked([&] { ccvt_points(n, row.capacity, row.finish, seed); }).cpu / n;
  };
  std::vector<double> few{seconds(kFew, 1), seconds(kFew, 2)};
  const double many = seconds(kMany, 1);
  few.push_back(seconds(kFew, 3));
  few.push_back(seconds(kFew, 4));
  double mean = 0;
  for (const double s : few) mean += s / static_cast<double>(few.size());
  report.row(row.name, {{"us_a_point_4096", 1e6 * mean},
                        {"us_a_point_65536", 1e6 * many},
                        {"ratio", many / mean, 1.4, Figure::kAtMost}});
}

void run_fpo(std::uint32_t n, int repeats, double cpu_goal, Report& report) {
  std::vector<double> cpu, least, mean;
  for (int r = 0; r < repeats; ++r) {
    FpoOptions options;
    options.n = n;
    options.seed = static_cast<std::uint64_t>(r) + 1;
    Points points;
    cpu.push_back(clocked([&] { points = fpo(options); }).cpu);
    const Measures m = measure(points);
    least.push_back(m.delta_min);
    mean.push_back(m.delta_mean);
  }
  report.row(fmt::format("fpo-{}", n),
             {{"cpu_s", median(cpu), cpu_goal, cpu_goal > 0 ? Figure::kAtMost : Figure::kNone},
              {"delta_min", median(least)},
              {"delta_min_worst", *std::min_element(least.begin(), least.end()), 0.925, Figure::kAtLeast},
              {"delta_mean", median(mean)},
              {"delta_mean_worst", *std::min_element(mean.begin(), mean.end()), 0.932, Figure::kAtLeast}});
}

/// The text's example of a partition: 1024 points in 8 subsets, delta_mean 0.807 to 0.817, mean 0.810.
void run_partition(Report& report) {
  const Points points = generate("ccvt", {1024, 1, 64});
  std::vector<Points> subsets;
  const Clocked time = clocked([&] { subsets = split(points, partition(points, {8, 1}), 8); });
  double mean = 0, worst = 1;
  for (const Points& subset : subsets) {
    const double delta = measure(subset).delta_mean;
    mean += delta / static_cast<double>(subsets.size());
    worst = std::min(worst, delta);
  }
  report.row("partition-8x128", {{"cpu_s", time.cpu},
                                 {"delta_mean", mean, 0.81, Figure::kAtLeast},
                                 {"delta_mean_worst", worst, 0.8, Figure::kAtLeast}});
}

}  // namespace

int main(int count, char** words) {
  if (count > 1 &&
      std::string(words[1]) == "invariants") {  // the program beside this one, built with the checks
    std::string program = words[0];
    program.replace(program.rfind('/') + 1, std::string::npos, "points_checked_bench");
    ::execv(program.c_str(), words + 1);
    fmt::print(stderr, "{}: not found; build it too\n", program);
    return 2;
  }
  std::vector<std::string> wanted;
  bool json = false, quick = false;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--json")
      json = true;
    else if (word == "--quick")
      quick = true;
    else
      wanted.push_back(word);
  }
  const auto is_wanted = [&](const std::string& name, bool is_long) {
    if (wanted.empty()) return !(quick && is_long);
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  if (!json) fmt::print("{} threads; medians over seeds\n", thread_count());
  Report report(json);
  for (const CcvtRow& row : kCcvtRows) {
    if (is_wanted(row.name, row.is_long)) run(row, report);
  }
  for (const GrowthRow& row : kGrowthRows) {
    if (is_wanted(row.name, true)) run(row, report);
  }
  if (is_wanted("fpo-1024", false)) run_fpo(1024, 11, 0, report);
  if (is_wanted("fpo-4096", false)) run_fpo(4096, 7, 2, report);
  if (is_wanted("partition-8x128", false)) run_partition(report);
  return report.end();
}
