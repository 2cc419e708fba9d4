#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/kernel.h"

namespace capcon {

/// Specialisation constants, id -> value.
using Constants = std::map<std::uint32_t, std::uint32_t>;

/// The kernels of shaders/, compiled on first use and kept: one a (name, specialisation). The driver may
/// compile as late as the first dispatch, so that a kernel is run once on nothing when it is made, and the
/// time of both is counted.
class Kernels {
 public:
  /// `texel_fetch`: the variants that read trees and tables by image loads, else by storage buffers.
  Kernels(const gpu::Device& device, bool texel_fetch);

  bool texel_fetch() const { return texel_fetch_; }
  /// Drops all kernels when the way to fetch changes.
  void set_texel_fetch(bool texel_fetch);

  /// The kernel "primary", "occlusion", "rays" or "points". `bind` is called with every kernel before it is
  /// first handed out.
  template <class Bind>
  gpu::Kernel& get(const std::string& name, const Constants& constants, const Bind& bind) {
    Entry& entry = compiled(name, constants);
    if (!entry.bound) {
      bind(*entry.kernel);
      entry.bound = true;
    }
    return *entry.kernel;
  }

  /// Compiles a kernel before its scene's buffers are there: while the scene is still being read or built.
  /// Not at the same time as anything else on the device.
  void prepare(const std::string& name, const Constants& constants) { compiled(name, constants); }

  /// Seconds spent compiling since the last call.
  double take_compile_seconds();

 private:
  struct Entry {
    std::unique_ptr<gpu::Kernel> kernel;
    bool bound = false;
  };
  Entry& compiled(const std::string& name, const Constants& constants);
  std::unique_ptr<gpu::Kernel> make(const std::string& name, const Constants& constants);
  void warm_up(gpu::Kernel& kernel);

  const gpu::Device& device_;
  bool texel_fetch_;
  gpu::Buffer nothing_;  ///< zeros that the warm-up run may read
  std::map<std::pair<std::string, Constants>, Entry> kernels_;
  double compile_seconds_ = 0;
};

}  // namespace capcon
