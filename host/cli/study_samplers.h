#pragma once

#include "study/plan.h"

namespace capcon::cli {

/// Makes the samplers of a study those that are usual where none are named, gives files of points a short
/// name each (StudySettings::point_files), which tables and files can hold, and checks all of them.
/// InputError for an unknown one, an unreadable file, one that is named twice.
void settle_samplers(StudySettings& settings);

/// InputError where a file of points has too few of them for one of the study's jobs: told before the work.
void check_point_files(const StudySettings& settings);

}  // namespace capcon::cli
