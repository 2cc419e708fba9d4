#include "bench/embree_tracer.h"

#include "base/error.h"

#ifdef CAPCON_EMBREE

#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>

#include "base/parallel.h"
#include "layout.h"

namespace capcon {

struct EmbreeTracer::State {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  std::vector<std::uint32_t> ids;  // by Embree's primitive number
  double build_seconds = 0;
  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

namespace {

constexpr std::size_t kStream = 1024;

void set_ray(RTCRayHit& r, const DeviceRay& ray) {
  r.ray = {ray.origin.x,
           ray.origin.y,
           ray.origin.z,
           0,
           ray.direction.x,
           ray.direction.y,
           ray.direction.z,
           0,
           ray.t_max,
           0xffffffffu,
           0,
           0};
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.primID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

void cast_single(RTCScene scene, std::span<const DeviceRay> rays, bool any,
                 const std::vector<std::uint32_t>& ids, std::span<DeviceHit> hits) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRayHit r;
    set_ray(r, rays[i]);
    if (any) {
      rtcOccluded1(scene, &context, &r.ray);
      hits[i] = {r.ray.tfar, r.ray.tfar < 0 ? 0 : layout::kNoPrimitive};
    } else {
      rtcIntersect1(scene, &context, &r);
      hits[i] = {r.ray.tfar,
                 r.hit.primID == RTC_INVALID_GEOMETRY_ID ? layout::kNoPrimitive : ids[r.hit.primID]};
    }
  }
}

void cast_wide(RTCScene scene, std::span<const DeviceRay> rays, bool any,
               const std::vector<std::uint32_t>& ids, std::span<DeviceHit> hits) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) int valid[16];
  for (std::size_t from = 0; from < rays.size(); from += 16) {
    RTCRayHit16 r;
    for (std::size_t k = 0; k < 16; ++k) {
      valid[k] = from + k < rays.size() ? -1 : 0;
      const DeviceRay& ray = rays[std::min(from + k, rays.size() - 1)];
      r.ray.org_x[k] = ray.origin.x, r.ray.org_y[k] = ray.origin.y, r.ray.org_z[k] = ray.origin.z;
      r.ray.dir_x[k] = ray.direction.x, r.ray.dir_y[k] = ray.direction.y, r.ray.dir_z[k] = ray.direction.z;
      r.ray.tnear[k] = 0, r.ray.tfar[k] = ray.t_max, r.ray.time[k] = 0;
      r.ray.mask[k] = 0xffffffffu, r.ray.id[k] = 0, r.ray.flags[k] = 0;
      r.hit.geomID[k] = r.hit.primID[k] = r.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    if (any) {
      rtcOccluded16(valid, scene, &context, &r.ray);
    } else {
      rtcIntersect16(valid, scene, &context, &r);
    }
    for (std::size_t k = 0; k < 16 && from + k < rays.size(); ++k) {
      const bool met = any ? r.ray.tfar[k] < 0 : r.hit.primID[k] != RTC_INVALID_GEOMETRY_ID;
      hits[from + k] = {r.ray.tfar[k], !met ? layout::kNoPrimitive : any ? 0 : ids[r.hit.primID[k]]};
    }
  }
}

void cast_stream(RTCScene scene, std::span<const DeviceRay> rays, bool any,
                 const std::vector<std::uint32_t>& ids, std::span<DeviceHit> hits) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  std::vector<RTCRayHit> block(kStream);
  for (std::size_t from = 0; from < rays.size(); from += kStream) {
    const std::size_t count = std::min(kStream, rays.size() - from);
    for (std::size_t k = 0; k < count; ++k) set_ray(block[k], rays[from + k]);
    if (any) {
      rtcOccluded1M(scene, &context, &block[0].ray, static_cast<unsigned>(count), sizeof(RTCRayHit));
    } else {
      rtcIntersect1M(scene, &context, block.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const bool met = any ? block[k].ray.tfar < 0 : block[k].hit.primID != RTC_INVALID_GEOMETRY_ID;
      hits[from + k] = {block[k].ray.tfar, !met ? layout::kNoPrimitive : any ? 0 : ids[block[k].hit.primID]};
    }
  }
}

}  // namespace

EmbreeTracer::EmbreeTracer(const Geometry& geometry) : state_(std::make_unique<State>()) {
  std::vector<glm::vec3> vertices;
  std::vector<bool> known(geometry.triangle_count +
                          geometry.quadric_count);  // by id: some lie in several leaves
  for (std::size_t slot = 0; slot < geometry.primitives.size() / 3; ++slot) {
    const std::uint32_t id = geometry.primitives[3 * slot].w;
    if ((id & layout::kQuadricBit) != 0 || known[id]) continue;
    known[id] = true;
    state_->ids.push_back(id);
    for (int k = 0; k < 3; ++k) {
      const glm::uvec4 w = geometry.primitives[3 * slot + k];
      vertices.emplace_back(std::bit_cast<float>(w.x), std::bit_cast<float>(w.y), std::bit_cast<float>(w.z));
    }
  }
  const RTCGeometry mesh = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions =
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, vertices.size());
  std::memcpy(positions, vertices.data(), 12 * vertices.size());
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, vertices.size() / 3));
  for (std::size_t i = 0; i < vertices.size(); ++i) indices[i] = static_cast<std::uint32_t>(i);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(state_->scene, mesh);
  rtcReleaseGeometry(mesh);
  const auto start = std::chrono::steady_clock::now();
  rtcCommitScene(state_->scene);
  state_->build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool EmbreeTracer::available() {
  return true;
}

void EmbreeTracer::cast(std::span<const DeviceRay> rays, bool any, Call call,
                        std::vector<DeviceHit>& hits) const {
  hits.resize(rays.size());
  const auto cast = call == Call::single ? cast_single : call == Call::wide ? cast_wide : cast_stream;
  constexpr std::size_t kPiece = 8 * kStream;
  parallel_for((rays.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t first = piece * kPiece, count = std::min(kPiece, rays.size() - first);
    cast(state_->scene, rays.subspan(first, count), any, state_->ids, std::span(hits).subspan(first, count));
  });
}

double EmbreeTracer::build_seconds() const {
  return state_->build_seconds;
}

}  // namespace capcon

#else

namespace capcon {

struct EmbreeTracer::State {};
EmbreeTracer::EmbreeTracer(const Geometry&) {
  throw Failure("this build has no Embree to compare with; install libembree-dev and build again");
}
bool EmbreeTracer::available() {
  return false;
}
void EmbreeTracer::cast(std::span<const DeviceRay>, bool, Call, std::vector<DeviceHit>&) const {}
double EmbreeTracer::build_seconds() const {
  return 0;
}

}  // namespace capcon

#endif

namespace capcon {
EmbreeTracer::~EmbreeTracer() = default;
}  // namespace capcon
