#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "gpu/commands.h"
#include "gpu/kernel.h"

namespace capcon {

/// The kernels of shaders/, compiled on first use and kept: one a (name, specialisation). The driver may compile as late as
/// the first dispatch, so that a kernel is run once on nothing when it is made, and the time of both is counted.
class Kernels {
 public:
  /// `texel_fetch`: the variants that read trees and tables by image loads, else by storage buffers.
  Kernels(const gpu::Device& device, bool texel_fetch) : device_(device), texel_fetch_(texel_fetch) {}

  /// The kernel "primary", "occlusion" or "points". `bind` is called with every new kernel before its first run.
  template <class Bind>
  gpu::Kernel& get(const std::string& name, const std::map<std::uint32_t, std::uint32_t>& constants, const Bind& bind) {
    auto& slot = kernels_[{name, constants}];
    if (!slot) {
      slot = make(name, constants);
      bind(*slot);
      warm_up(*slot);
    }
    return *slot;
  }

  /// Seconds spent compiling since the last call.
  double take_compile_seconds();

 private:
  std::unique_ptr<gpu::Kernel> make(const std::string& name, const std::map<std::uint32_t, std::uint32_t>& constants);
  void warm_up(const gpu::Kernel& kernel);

  const gpu::Device& device_;
  bool texel_fetch_;
  std::map<std::pair<std::string, std::map<std::uint32_t, std::uint32_t>>, std::unique_ptr<gpu::Kernel>> kernels_;
  double compile_seconds_ = 0;
};

}  // namespace capcon
