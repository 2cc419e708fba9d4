#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>

#include "gpu/kernel.h"

namespace capcon {

/// How many lanes each kernel gets in one dispatch, so that none comes near a watchdog: desktop drivers end
/// work that takes about 2 s. A kernel starts small; the size follows the device's own clock. No bit of an
/// image depends on it.
class Batches {
 public:
  /// `most`: lanes that there is room for. `fixed`: always so many, for tests; 0: adapted.
  explicit Batches(std::uint64_t most, std::uint64_t fixed = 0);

  /// Lanes of the next dispatch of `kernel`, at least 1.
  std::uint64_t lanes(const gpu::Kernel& kernel) const;
  /// The same where a dispatch feeds or is followed by some of several kernels: the fewest of them.
  std::uint64_t lanes(std::initializer_list<const gpu::Kernel*> kernels) const;
  /// Of a kernel that gets what others find, and rarely as many lanes as it could: all, until one of its
  /// dispatches was slow.
  std::uint64_t lanes_onwards(const gpu::Kernel& kernel) const;

  /// A dispatch of so many lanes took so long.
  void took(const gpu::Kernel& kernel, std::uint64_t lanes, double seconds);

  static constexpr double kAim = 0.25;  ///< seconds of a dispatch

 private:
  struct Size {
    std::uint64_t lanes;
    bool slow = false;
    double worst = 0;  ///< seconds a lane
  };
  std::uint64_t most_, fixed_;
  std::map<const gpu::Kernel*, Size> sizes_;
};

}  // namespace capcon
