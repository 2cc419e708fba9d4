#pragma once

#include <optional>

#include "distributed/ranks.h"
#include "study/runner.h"

namespace capcon {

/// A study by the ranks of an MPI job, each a shard of it: rank 0 hands back the merged result when all are
/// done, the others wait for let_go() and hand back nothing. A rank that dies loses the job that it was at:
/// where the launcher lets the others live (mpirun --enable-recovery), they finish theirs, then one sentence
/// says what is missing, and all end with exit code 1.
std::optional<StudyResult> run_by_ranks(const StudySettings& settings, const StudyDevice& device,
                                        const RunnerOptions& options, const Ranks& ranks);

/// Rank 0, when the report is written: the others may end.
void let_go(const Ranks& ranks);

}  // namespace capcon
