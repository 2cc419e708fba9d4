#include "points/ccvt_optimise.h"

#include <algorithm>

#include "points/ccvt_exchange.h"
#include "points/ccvt_pairs.h"

namespace capcon {

CcvtEffort optimise(CcvtCells& cells, std::uint64_t enough,
                    const std::function<void(std::uint64_t)>& on_pass) {
  CcvtPairs pairs;
  CcvtScratch scratch;
  CcvtEffort effort;
  std::uint32_t now = 1;        // counts batches; sites begin as changed at 1
  std::uint32_t last_pass = 0;  // when the pass before began
  for (CcvtSite& site : cells.sites) site.changed = 1;
  for (;;) {
    // A pair of sites that stayed as they were all through the last pass was checked then, or did not
    // overlap: that is all that pairs found anew need to know.
    pairs.refresh(cells, last_pass);
    last_pass = now;
    std::uint64_t swaps = 0;
    for (std::size_t batch = 0; batch < pairs.batches(); ++batch) {
      ++now;
      for (auto* pair = pairs.begin(batch); pair != pairs.end(batch); ++pair) {
        CcvtSite& a = cells.sites[pair->i];
        CcvtSite& b = cells.sites[pair->j];
        if (std::max(a.changed, b.changed) <= pair->checked) continue;
        const std::uint32_t count = exchange(cells, pair->i, pair->j, scratch);
        pair->checked = now;
        if (count == 0) continue;
        swaps += count;
        pair->checked = now - 1;  // the sites have moved: there may be more to gain
        a.changed = b.changed = now;
      }
    }
    ++effort.passes;
    effort.swaps += swaps;
    if (on_pass) on_pass(swaps);
    if (swaps < enough) return effort;
  }
}

}  // namespace capcon
