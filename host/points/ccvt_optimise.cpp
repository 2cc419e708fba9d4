#include "points/ccvt_optimise.h"

#include <algorithm>

#include "base/parallel.h"
#include "points/ccvt_exchange.h"
#include "points/ccvt_pairs.h"

namespace capcon {

namespace {

/// Above so many arrivals a look at the points is cheaper than to keep account of them.
constexpr std::uint32_t kFew = 8;
constexpr std::uint32_t kLarge = 128;  // capacity from which it is worth it
constexpr std::size_t kTask = 512;     // pairs a task; a smaller batch is not worth a thread

/// Works on one pair and tells the others of both sites. Returns the number of points exchanged.
std::uint32_t work_on(CcvtCells& cells, CcvtPairs& pairs, CcvtPairs::Pair& pair, CcvtScratch& scratch) {
  if (pairs.is_settled(cells, pair)) return 0;
  const double travel = cells.sites[pair.i].travel + cells.sites[pair.j].travel;
  const std::uint32_t count = exchange(cells, pair.i, pair.j, scratch);
  pair.front = scratch.front;
  pair.travel = travel;
  if (count == 0) return 0;
  const auto tell = [&](std::uint32_t i, const std::vector<CcvtCandidate>& slots, bool refitted) {
    if (refitted)
      pairs.forget(i, nullptr);
    else if (count > kFew)
      pairs.forget(i, &pair);
    else
      pairs.note_arrivals(cells, i, slots, count, pair);
  };
  tell(pair.i, scratch.from_i, scratch.refitted_i);
  tell(pair.j, scratch.from_j, scratch.refitted_j);
  return count;
}

}  // namespace

CcvtEffort optimise(CcvtCells& cells, std::uint64_t enough, const std::function<void(std::uint64_t)>& on_pass,
                    const std::function<bool()>& stop) {
  CcvtPairs pairs(cells.capacity() >= kLarge);
  CcvtEffort effort;
  CcvtScratch scratch;
  for (;;) {
    pairs.refresh(cells);
    std::uint64_t swaps = 0;
    for (std::size_t batch = 0; batch < pairs.batches(); ++batch) {
      const std::size_t size = pairs.batch_size(batch);
      if (size < 2 * kTask) {
        for (std::size_t k = 0; k < size; ++k) swaps += work_on(cells, pairs, pairs.pair(batch, k), scratch);
        continue;
      }
      std::vector<std::uint64_t> counts((size + kTask - 1) / kTask, 0);
      parallel_for(counts.size(), [&](std::size_t task) {
        CcvtScratch own;
        for (std::size_t k = task * kTask; k < std::min(size, (task + 1) * kTask); ++k)
          counts[task] += work_on(cells, pairs, pairs.pair(batch, k), own);
      });
      for (const std::uint64_t count : counts) swaps += count;
    }
    ++effort.passes;
    effort.swaps += swaps;
    if (on_pass) on_pass(swaps);
    if (swaps < enough) return effort;
    if (stop && stop()) {
      effort.stopped = true;
      return effort;
    }
  }
}

}  // namespace capcon
