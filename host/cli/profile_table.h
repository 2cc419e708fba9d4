#pragma once

#include <string>

#include "scene/job.h"

namespace capcon::cli {

/// One row a stage of a render, in the order of the work, wall and device milliseconds; stages that the job
/// does not have are named as left out. Stages overlap, so that the rows may add up to more than the whole.
std::string profile_table(const Timings& timings, double whole_seconds, double first_dispatch_seconds);

}  // namespace capcon::cli
