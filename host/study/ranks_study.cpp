#include "study/ranks_study.h"

#include <fmt/format.h>

#include "base/error.h"
#include "study/merge.h"
#include "study/shard.h"
#include "study/study_lock.h"

namespace capcon {
namespace fs = std::filesystem;

namespace {

/// A word between ranks; that it comes is all it says.
void send_word(const Ranks& ranks, int to) {
  const std::byte word{1};
  ranks.send(to, {&word, 1});
}

/// All have come here.
void gather_words(const Ranks& ranks) {
  std::byte word{};
  if (!ranks.first()) send_word(ranks, 0);
  for (int rank = 1; ranks.first() && rank < ranks.size(); ++rank) ranks.receive(rank, {&word, 1});
}

/// False where the other has died. What tells is the lock on its folder, if locks tell anything here.
bool await_word(const Ranks& ranks, int from, const fs::path& folder, bool locks_tell) {
  std::byte word{};
  return ranks.receive(from, {&word, 1}, [&] { return !locks_tell || StudyLock::taken(folder); });
}

Shard shard_of(int rank, const Ranks& ranks) {
  return {static_cast<std::uint32_t>(rank) + 1, static_cast<std::uint32_t>(ranks.size())};
}

}  // namespace

std::optional<StudyResult> run_by_ranks(const StudySettings& settings, const StudyDevice& device,
                                        const RunnerOptions& options, const Ranks& ranks) {
  const fs::path& study = options.directory;
  const fs::path own = shard_folder(study, shard_of(ranks.rank(), ranks));
  const StudyLock at_work(own);
  const bool locks_tell = StudyLock::taken(own);
  gather_words(ranks);  // from here on the locks of all are there
  const ReferenceImage reference = shared_reference(settings, device, options, ranks);
  run_shard(settings, device, options, shard_of(ranks.rank(), ranks), reference);
  if (!ranks.first()) {
    send_word(ranks, 0);
    if (!await_word(ranks, 0, study, locks_tell))
      throw Failure("the first rank ended before it had made the report; give the same command again");
    return std::nullopt;
  }
  bool all_live = true;
  for (int rank = 1; rank < ranks.size(); ++rank)
    all_live = await_word(ranks, rank, shard_folder(study, shard_of(rank, ranks)), locks_tell) && all_live;
  try {
    return merge_shards(study, {study}, shard_hash(settings, reference));
  } catch (const Failure& failure) {
    if (all_live) throw;
    fmt::print(stderr, "capcon: a rank died; {}\n", failure.what());
    ranks.end_all(1);
  }
}

void let_go(const Ranks& ranks) {
  for (int rank = 1; rank < ranks.size(); ++rank) send_word(ranks, rank);
}

}  // namespace capcon
