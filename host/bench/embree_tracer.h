#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/geometry.h"
#include "render/ray_caster.h"

namespace capcon {

/// Embree's answers to the same rays, for comparison; there only where the build found Embree.
class EmbreeTracer {
 public:
  enum class Call {
    single,  ///< rtcIntersect1, rtcOccluded1
    wide,    ///< rtcIntersect16, rtcOccluded16
    stream   ///< rtcIntersect1M, rtcOccluded1M over 1024 rays; primary rays marked coherent
  };

  /// The triangles of `geometry`, with its ids; its instances as Embree's, where it has two levels. Quadrics
  /// are left out.
  explicit EmbreeTracer(const Geometry& geometry);
  ~EmbreeTracer();

  /// Whether this build has Embree. Without it the constructor throws Failure.
  static bool available();

  double build_seconds() const;
  /// Casts all rays, on all threads, as the device has them.
  void cast(std::span<const DeviceRay> rays, bool any, Call call, std::vector<DeviceHit>& hits) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace capcon
