#include "stability/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "stability/cases.h"
#include "stability/checks.h"

namespace capcon::stability {
namespace {

/// What the short form keeps: one of a kind, and none that takes long.
const std::set<std::string> kBrief = {"direct-scaled-1e-06",
                                      "igi-small-and-moved",
                                      "ao-moved-1e+06",
                                      "ao-from-afar-1e+06",
                                      "needles",
                                      "useless",
                                      "radius-tiny",
                                      "sphere-light-1e-15",
                                      "radiance-1e30",
                                      "environment-1e8",
                                      "measured-holes",
                                      "corner-1e-6",
                                      "ao-bits",
                                      "watertight",
                                      "ao-sums",
                                      "points-contrast-1e12",
                                      "direct-one-ulp"};

void append(std::vector<Task>& tasks, const std::vector<ImageCase>& cases, const Workshop& workshop) {
  for (const ImageCase& c : cases) tasks.push_back({c.group, c.name, [=] { return run_case(c, workshop); }});
}

void append(std::vector<Task>& tasks, const std::vector<Task>& more) {
  tasks.insert(tasks.end(), more.begin(), more.end());
}

std::vector<Task> all_tasks(const SuiteOptions& options) {
  const Workshop workshop{options.device, options.folder};
  std::vector<Task> tasks;
  append(tasks, place_cases(), workshop);
  append(tasks, bit_tasks(workshop));
  append(tasks, geometry_cases(), workshop);
  append(tasks, leak_tasks(workshop, options.brief ? 1'000'000 : 100'000'000));
  append(tasks, integrand_cases(), workshop);
  append(tasks, virtual_light_cases(), workshop);
  append(tasks, sum_tasks(workshop, options.brief ? 12 : 24));
  append(tasks, point_tasks());
  append(tasks, condition_tasks(workshop));
  append(tasks, limit_tasks(workshop));
  if (options.brief && options.only.empty())
    std::erase_if(tasks, [](const Task& t) { return !kBrief.count(t.name); });
  if (options.only.empty()) return tasks;
  for (const std::string& name : options.only) {
    if (std::none_of(tasks.begin(), tasks.end(),
                     [&](const Task& t) { return t.name == name || t.group == name; }))
      throw InputError(
          fmt::format("there is no check or group \"{}\"; capcon stability --list names them", name));
  }
  std::erase_if(tasks, [&](const Task& t) {
    return std::none_of(options.only.begin(), options.only.end(),
                        [&](const std::string& n) { return t.name == n || t.group == n; });
  });
  return tasks;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> names_of_checks(const SuiteOptions& options) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const Task& task : all_tasks(options)) names.emplace_back(task.group, task.name);
  return names;
}

std::vector<Check> run_suite(const SuiteOptions& options,
                             const std::function<void(const Check&, std::size_t)>& on_check) {
  const std::vector<Task> tasks = all_tasks(options);
  // A device that is not there is one sentence, not a check after the other that failed.
  RendererOptions device;
  device.device = options.device;
  if (std::any_of(tasks.begin(), tasks.end(), [](const Task& t) { return t.group != "points"; }))
    open_device(device).get();
  std::vector<Check> checks;
  for (const Task& task : tasks) {
    try {
      checks.push_back(task.run());
    } catch (const std::exception& error) {
      Check failed;
      failed.group = task.group;
      failed.name = task.name;
      failed.measured = error.what();
      failed.bound = "a result";
      checks.push_back(failed);
    }
    on_check(checks.back(), tasks.size());
  }
  return checks;
}

}  // namespace capcon::stability
