#include <fmt/format.h>

#include <cmath>

#include "study/findings.h"
#include "study/format.h"
#include "study/overlay.h"

namespace capcon {

std::vector<std::string> make_findings(const Overlay& o) {
  const StudySettings& settings = o.studies[0].result.settings;
  StudySettings spoken = settings;
  spoken.samples = o.samples;
  spoken.samplers = o.samplers;
  const std::uint32_t n = spoken_count(spoken);
  const std::string subject = study_subject(spoken);
  const std::string many(words_of(settings.integral).many);
  std::vector<std::string> findings, more;
  for (const Beside& b : o.beside) {
    const std::string &here = o.labels[b.study], &there = o.labels[0];
    const Ratio* r = o.ratio(b, subject, n);
    if (r && !std::isnan(r->equal_error_time.value)) {
      Interval samples = r->equal_error;
      for (double* v : {&samples.value, &samples.low, &samples.high}) *v /= n;
      findings.push_back(
          fmt::format("For the error that {} {} of {} have in {}, {} needs {} times the device time and {}{}",
                      n, many, subject, there, here, with_range(r->equal_error_time),
                      b.same_errors ? fmt::format("as many {}", many)
                                    : fmt::format("{} times the {}", with_range(samples), many),
                      o.seeds < 2                    ? "; one seed does not say how sure that is."
                      : r->equal_error_time.below(1) ? ": it is faster."
                      : r->equal_error_time.above(1) ? ": it is slower."
                                                     : ": no difference in time is shown."));
    }
    if (b.same_errors) {
      more.push_back(fmt::format("{} and {} measured the same errors, bit by bit: only their times differ.",
                                 here, there));
      continue;
    }
    std::vector<std::string> less, greater;
    for (const Ratio& ratio : b.ratios) {
      if (ratio.samples != n) continue;
      if (ratio.mse.below(1)) less.push_back(fmt::format("{} ({})", ratio.sampler, with_range(ratio.mse)));
      if (ratio.mse.above(1)) greater.push_back(fmt::format("{} ({})", ratio.sampler, with_range(ratio.mse)));
    }
    if (less.empty() && greater.empty()) {
      more.push_back(fmt::format("At {} {} no sampler is shown to err more or less in {} than in {}.", n,
                                 many, here, there));
    } else {
      std::string text = fmt::format("At {} {}, {} beside {}:", n, many, here, there);
      if (!less.empty())
        text += fmt::format(" {} {} less", enumerate(less), less.size() == 1 ? "errs" : "err");
      if (!greater.empty())
        text += fmt::format("{} {} {} more", less.empty() ? "" : ", and", enumerate(greater),
                            greater.size() == 1 ? "errs" : "err");
      more.push_back(text + ".");
    }
  }
  findings.insert(findings.end(), more.begin(), more.end());
  return findings;
}

}  // namespace capcon
