#include "points/ccvt_optimise.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "points/ccvt_checks.h"
#include "points/ccvt_exchange.h"
#include "points/ccvt_leads.h"
#include "points/ccvt_pairs.h"
#include "points/checks.h"

namespace capcon {

namespace {

/// Above so many arrivals a look at the points is cheaper than to keep account of them.
constexpr std::uint32_t kFew = 8;
constexpr int kSweeps = 3;             // over the pairs of a block in one pass
constexpr double kWorthThreads = 4e5;  // nanoseconds of a phase from which threads are worth starting

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

CcvtPace coarse_pace(std::size_t sites, std::uint32_t capacity) {
  const std::uint64_t enough = 1 + sites * capacity / 1024;
  // Leads pay most where passes are cheap. Measured at n = 1024 on the way to a capacity of 1024: half the
  // time of a way without them, and E_ot lower by 0.005.
  if (capacity < 32) return {enough};
  if (capacity < 128) return {enough, 10, 1.8};
  return {enough, 5, 1.3};
}

CcvtEffort optimise(CcvtCells& cells, const CcvtPace& pace, const std::function<void(std::uint64_t)>& on_pass,
                    const std::function<bool()>& stop) {
  CcvtPairs pairs(cells.capacity());
  CcvtEffort effort;
  CcvtScratch scratch;
  CcvtLeads leads(pace.lead);
  double exchanges_a_pair = 1;  // in the last pass
  const auto content = [&] { return content_of(cells.x(0), cells.y(0), cells.size() * cells.capacity()); };
  [[maybe_unused]] std::uint64_t content_before = 0;
  if constexpr (kChecks) content_before = content();
  // The passes end: without leads every exchange lowers the energy by more than its rounding
  // (ccvt_exchange.cpp), so no assignment of the points comes twice, and there are finitely many. With leads
  // a pace has its most passes.
  for (;;) {
    leads.renew(cells);
    pairs.refresh(cells);
    // About 8 ns a pair, and three looks at the points of two cells for each exchange: a guess, for the time
    // only.
    const double pair_cost = 8 + 2.0 * cells.capacity() * exchanges_a_pair;
    std::uint64_t swaps = 0;
    for (std::size_t phase = 0; phase < pairs.phases(); ++phase) {
      const std::size_t first = pairs.first_task(phase), tasks = pairs.first_task(phase + 1) - first;
      std::vector<std::uint64_t> counts(tasks, 0);
      const auto work = [&](std::size_t task, CcvtScratch& own) {
        // Again while the block is in the cache: what is left to gain there costs less now than in the next
        // pass.
        for (int sweep = 0; sweep < (phase == 0 ? kSweeps : 1); ++sweep) {
          const std::uint64_t before = counts[task];
          for (CcvtPairs::Pair& pair : pairs.task(first + task))
            counts[task] += work_on(cells, pairs, pair, own);
          if (counts[task] == before) break;
        }
      };
      if (static_cast<double>(pairs.size(phase)) * pair_cost < kWorthThreads) {
        for (std::size_t task = 0; task < tasks; ++task) work(task, scratch);
      } else {
        parallel_for(tasks, [&](std::size_t task) {
          CcvtScratch own;
          work(task, own);
        });
      }
      swaps = std::accumulate(counts.begin(), counts.end(), swaps);
    }
    exchanges_a_pair =
        static_cast<double>(swaps) / static_cast<double>(std::max<std::size_t>(1, pairs.size()));
    ++effort.passes;
    effort.swaps += swaps;
    if (on_pass) on_pass(swaps);
    if (swaps < pace.enough || effort.passes == pace.most_passes) break;
    if (stop && stop()) {
      effort.stopped = true;
      break;
    }
  }
  leads.end(cells);
  if constexpr (kChecks)
    require(content() == content_before, "ccvt: the passes lost or doubled a space point");
  return effort;
}

}  // namespace capcon
