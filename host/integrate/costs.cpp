#include "integrate/costs.h"

#include <ctime>

#include "integrate/trials.h"

namespace capcon::integrate {
namespace {

double thread_seconds() {
  std::timespec t{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Processor seconds of one call, after one to warm up.
template <class Work>
double seconds_of(const Work& work) {
  constexpr double kEnough = 0.2e-3;
  work();
  double repeats = 0;
  const double start = thread_seconds();
  for (double batch = 1;; batch *= 2) {
    for (double k = 0; k < batch; ++k) work();
    repeats += batch;
    const double elapsed = thread_seconds() - start;
    if (elapsed >= kEnough) return elapsed / repeats;
  }
}

volatile double sink = 0;  // keeps the estimates from being optimised away

}  // namespace

CostMeter::CostMeter(const PointSource& source) : source_(source), points_(source.set(0)) {
  seconds_ = seconds_of([&] { sink = source_.set(0).front().x; });
}

Cost CostMeter::cost(const Integrand& integrand, const Draw& draw, Weights weights) {
  Cost cost{source_.preparation_seconds, seconds_, 0, 0};
  if (weights == Weights::areas) {
    const bool torus = integrand.domain == Domain::torus;
    std::optional<double>& seconds = cell_costs_[torus];
    if (!seconds)
      seconds = seconds_of([&] {
        const TorusCells cells = torus_cells(points_);
        sink = (torus ? torus_sums(cells) : square_sums(points_, cells)).energy;
      });
    cost.weights = *seconds;
  }
  const Weights loop = weights == Weights::importance ? weights : Weights::equal;
  cost.evaluation =
      seconds_of([&] { sink = TrialPoints(source_, 0, points_).estimate(integrand, draw, loop); });
  return cost;
}

}  // namespace capcon::integrate
