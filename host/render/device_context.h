#pragma once

#include <future>
#include <memory>
#include <string>

#include "gpu/device.h"
#include "gpu/instance.h"
#include "render/kernels.h"

namespace capcon {

struct RendererOptions {
  /// "best", "lavapipe", a number as `capcon info` lists it, or part of a device's name.
  std::string device = "best";
  /// "auto" (image loads on CPU devices and for scenes beyond what a storage buffer binds, else storage
  /// buffers), "texel" or "storage".
  std::string fetch = "auto";
  /// "auto" (one tree over all instances where that is small or saves little), "flat" or "two-level".
  std::string instancing = "auto";
  /// "auto" (best where the first job's rays pay for it), "fast" or "best": whether primitives may be cut for
  /// a better tree.
  std::string tree = "auto";
  bool shading = false;   ///< prepare for direct lighting, whatever the first job is
  bool validate = false;  ///< load the Khronos validation layer; its messages make the render fail
  /// Lanes of each dispatch, for tests; 0: adapted to the device's speed. No bit of an image depends on it.
  std::uint64_t batch_lanes = 0;
  /// Iterations of its loops after which a subgroup begins no more rays of its queue (render/ray_queue.h): far
  /// below the 65,535 after which lavapipe ends an invocation. Tests may want fewer.
  std::uint32_t queue_iterations = 16384;
  bool keep_everything =
      false;  ///< upload and compile what the job does not need, too: for `capcon render --explain`
};

/// An open device and its kernels: what does not depend on the scene.
struct DeviceContext {
  explicit DeviceContext(const RendererOptions& options);

  gpu::Instance instance;
  gpu::DeviceDescription description;
  gpu::Device device;
  Kernels kernels;
  double open_seconds = 0;
};

/// Opens the device on another thread, so that the scene can be read meanwhile. Failure and InputError come
/// out of get().
using PendingDevice = std::future<std::unique_ptr<DeviceContext>>;
PendingDevice open_device(const RendererOptions& options);

}  // namespace capcon
