#include "distributed/share_renderer.h"

#include <algorithm>
#include <exception>
#include <vector>

#include "base/error.h"

namespace capcon {
namespace {

/// What rank 0 asks for; no rows: nothing any more.
struct Rows {
  int first = 0, count = 0;
};

/// "0,1,3" as three, anything else as one: names may have commas.
std::vector<std::string> listed(const std::string& devices) {
  if (devices.find_first_not_of("0123456789,") != std::string::npos) return {devices};
  std::vector<std::string> numbers(1);
  for (const char c : devices) {
    if (c == ',') {
      numbers.emplace_back();
    } else {
      numbers.back() += c;
    }
  }
  return numbers;
}

}  // namespace

ShareRenderer::ShareRenderer(const Ranks& ranks, Job job, RenderRows render)
    : ranks_(ranks), job_(std::move(job)), render_(std::move(render)) {
  if (ranks.alone()) return;
  if (!can_be_shared(job_)) throw InputError("path tracing is for one process: leave out mpirun");
  job_ =
      with_share(job_, {static_cast<std::uint32_t>(ranks.rank()), static_cast<std::uint32_t>(ranks.size())});
}

ShareRenderer::~ShareRenderer() {
  if (ranks_.first() && std::uncaught_exceptions() == 0) ranks_.broadcast_value(Rows{});
}

RenderResult ShareRenderer::share(int first_row, int rows, const std::function<void(double)>& on_progress) {
  RenderResult result = render_(job_, first_row, rows, on_progress);
  if (ranks_.alone()) return result;
  ranks_.add_up(result.sums);
  // Below 2^53 doubles are whole numbers, too.
  double rays = static_cast<double>(result.rays);
  ranks_.add_up({&rays, 1});
  result.rays = static_cast<std::uint64_t>(rays);
  return result;
}

RenderResult ShareRenderer::render_rows(int first_row, int rows,
                                        const std::function<void(double)>& on_progress) {
  ranks_.broadcast_value(Rows{first_row, rows});
  RenderResult result = share(first_row, rows, on_progress);
  finish_shares(result);
  return result;
}

void ShareRenderer::help() {
  for (Rows rows = ranks_.broadcast_value(Rows{}); rows.count > 0; rows = ranks_.broadcast_value(Rows{}))
    share(rows.first, rows.count, {});
}

std::string device_of_rank(const std::string& devices, int on_this_machine) {
  const std::vector<std::string> numbers = listed(devices);
  return numbers[static_cast<std::size_t>(on_this_machine) % numbers.size()];
}

bool share_a_device(const std::string& devices, int ranks_of_machine) {
  std::vector<std::string> numbers = listed(devices);
  std::sort(numbers.begin(), numbers.end());
  return std::unique(numbers.begin(), numbers.end()) - numbers.begin() < ranks_of_machine;
}

}  // namespace capcon
