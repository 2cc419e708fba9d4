#include "render/batches.h"

#include <algorithm>

#include "layout.h"

namespace capcon {
namespace {

// A lane may take 60 us before the first dispatch is slow; a slow CPU device takes less than one.
constexpr std::uint64_t kFirst = 1 << 15;
constexpr double kGrowth = 4;   // pieces of an image differ in what they cost
constexpr double kLongest = 1;  // seconds, if all were as slow as the slowest so far

}  // namespace

Batches::Batches(std::uint64_t most, std::uint64_t fixed)
    : most_(std::max<std::uint64_t>(most, 1)), fixed_(std::min(fixed, most_)) {}

std::uint64_t Batches::lanes(const gpu::Kernel& kernel) const {
  if (fixed_ > 0) return fixed_;
  const auto found = sizes_.find(&kernel);
  return found == sizes_.end() ? std::min(kFirst, most_) : found->second.lanes;
}

std::uint64_t Batches::lanes(std::initializer_list<const gpu::Kernel*> kernels) const {
  std::uint64_t fewest = fixed_ > 0 ? fixed_ : most_;
  for (const gpu::Kernel* kernel : kernels) {
    if (kernel) fewest = std::min(fewest, lanes(*kernel));
  }
  return fewest;
}

std::uint64_t Batches::lanes_onwards(const gpu::Kernel& kernel) const {
  const auto found = sizes_.find(&kernel);
  return found != sizes_.end() && found->second.slow ? lanes(kernel) : most_;
}

void Batches::took(const gpu::Kernel& kernel, std::uint64_t lanes, double seconds) {
  if (fixed_ > 0 || lanes == 0) return;
  Size& size = sizes_.try_emplace(&kernel, Size{std::min(kFirst, most_)}).first->second;
  const double fitting = static_cast<double>(lanes) * std::min(kGrowth, kAim / std::max(seconds, 1e-9));
  const auto next = std::max<std::uint64_t>(static_cast<std::uint64_t>(fitting), layout::kGroupSize);
  // A small dispatch takes longer a lane than a large one: only a slow one says that there were too many.
  const bool slow = seconds > kAim;
  if (lanes >= kFirst / 8) size.worst = std::max(size.worst, seconds / static_cast<double>(lanes));
  const auto longest = static_cast<std::uint64_t>(std::min(kLongest / std::max(size.worst, 1e-12), 1e12));
  if (slow || next > size.lanes)
    size.lanes = std::min({next, most_, std::max<std::uint64_t>(longest, layout::kGroupSize)});
  size.slow = size.slow || slow;
}

}  // namespace capcon
