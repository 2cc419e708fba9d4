#pragma once

#include <functional>
#include <vector>

#include "stability/check.h"
#include "stability/image_case.h"

namespace capcon::stability {

/// A check by name, to be run when it is its turn.
struct Task {
  std::string group, name;
  std::function<Check()> run;
};

/// The room in units of 2^20 and of 2^-20: the same bits.
std::vector<Task> bit_tasks(const Workshop& workshop);
/// `rays` from within a closed mesh towards its edges and vertices, closest and any: none may get out.
std::vector<Task> leak_tasks(const Workshop& workshop, std::uint64_t rays);
/// Up to 2^most samples a pixel against closed forms: the error goes on falling as 1 / sqrt(n).
std::vector<Task> sum_tasks(const Workshop& workshop, int most);
/// Capacity-constrained sets of few points, capacities and densities that are hard: exact capacities, and an
/// optimum of swaps.
std::vector<Task> point_tasks();
/// How far images move when every number of the scene moves by one float ulp.
std::vector<Task> condition_tasks(const Workshop& workshop);
/// Where floats stop to be enough: ladders of ever more extreme scenes, and the rung from which on pixels
/// differ.
std::vector<Task> limit_tasks(const Workshop& workshop);

}  // namespace capcon::stability
