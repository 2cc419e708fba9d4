#include "bench/embree_tracer.h"

#include "base/error.h"

#ifdef CAPCON_EMBREE

#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <unordered_map>

#include "base/parallel.h"
#include "bench/geometry_triangles.h"
#include "layout.h"

namespace capcon {

namespace {

/// The ids of what Embree calls primitive `primitive` of instance `instance`.
struct Ids {
  std::vector<std::uint32_t> world;  // of what is in no object, or of everything
  struct Instance {
    const std::vector<std::uint32_t>* object;
    std::uint32_t first;
  };
  std::vector<Instance> instances;
  std::uint32_t of(unsigned primitive, unsigned instance) const {
    if (primitive == RTC_INVALID_GEOMETRY_ID) return layout::kNoPrimitive;
    if (instance == RTC_INVALID_GEOMETRY_ID) return world[primitive];
    return (*instances[instance].object)[primitive] + instances[instance].first;
  }
};

}  // namespace

struct EmbreeTracer::State {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  struct Object {
    RTCScene scene;
    std::vector<std::uint32_t> ids;
  };
  std::unordered_map<std::uint32_t, Object> objects;  // by the root of their tree
  Ids ids;
  double build_seconds = 0;
  ~State() {
    rtcReleaseScene(scene);
    for (auto& [root, object] : objects) rtcReleaseScene(object.scene);
    rtcReleaseDevice(device);
  }
};

namespace {

constexpr std::size_t kStream = 1024;

void add_triangles(RTCDevice device, RTCScene scene, const Geometry& geometry, const TriangleSlots& triangles,
                   unsigned number) {
  const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t count = triangles.slots.size();
  auto* positions = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * count));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto vertices = triangle_in_slot(geometry, triangles.slots[i]);
    std::copy(vertices.begin(), vertices.end(), positions + 3 * i);
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) indices[k] = static_cast<std::uint32_t>(k);
  }
  rtcCommitGeometry(mesh);
  rtcAttachGeometryByID(scene, mesh, number);
  rtcReleaseGeometry(mesh);
}

void add_instance(RTCDevice device, RTCScene scene, const InstanceRecord& record, RTCScene object,
                  std::size_t number) {
  const RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(instance, object);
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, record.to_world.data());
  rtcCommitGeometry(instance);
  rtcAttachGeometryByID(scene, instance, static_cast<unsigned>(number));
  rtcReleaseGeometry(instance);
}

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

void cast_single(RTCScene scene, std::span<const DeviceRay> rays, bool any, const Ids& ids,
                 std::span<DeviceHit> hits) {
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
      hits[i] = {r.ray.tfar, ids.of(r.hit.primID, r.hit.instID[0])};
    }
  }
}

void cast_wide(RTCScene scene, std::span<const DeviceRay> rays, bool any, const Ids& ids,
               std::span<DeviceHit> hits) {
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
      hits[from + k] = {r.ray.tfar[k], any ? (r.ray.tfar[k] < 0 ? 0 : layout::kNoPrimitive)
                                           : ids.of(r.hit.primID[k], r.hit.instID[0][k])};
    }
  }
}

void cast_stream(RTCScene scene, std::span<const DeviceRay> rays, bool any, const Ids& ids,
                 std::span<DeviceHit> hits) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  // Occlusion rays are not coherent; said to be, they take 2.6 times as long, and did not end in
  // ten minutes on the courtyard in instances (Embree 3.13.5).
  context.flags = any ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
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
      const RTCHit& hit = block[k].hit;
      hits[from + k] = {block[k].ray.tfar, any ? (block[k].ray.tfar < 0 ? 0 : layout::kNoPrimitive)
                                               : ids.of(hit.primID, hit.instID[0])};
    }
  }
}

}  // namespace

EmbreeTracer::EmbreeTracer(const Geometry& geometry) : state_(std::make_unique<State>()) {
  State& s = *state_;
  const auto add_world = [&](std::uint32_t root) {
    TriangleSlots triangles = triangle_slots(geometry, root);
    // Instances count from 0.
    add_triangles(s.device, s.scene, geometry, triangles, static_cast<unsigned>(geometry.instance_count()));
    s.ids.world = std::move(triangles.ids);
  };
  if (geometry.instances.empty()) add_world(0);
  const auto commit = [&](RTCScene scene) {
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(scene);
    s.build_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (std::size_t i = 0; i < geometry.instance_count(); ++i) {
    const InstanceRecord record = instance_record(geometry, i);
    if (record.world) {
      add_world(record.root);
      continue;
    }
    if (!s.objects.contains(record.root)) {
      State::Object& object = s.objects[record.root];
      object.scene = rtcNewScene(s.device);
      TriangleSlots triangles = triangle_slots(geometry, record.root);
      add_triangles(s.device, object.scene, geometry, triangles, 0);
      object.ids = std::move(triangles.ids);
      commit(object.scene);
    }
    const State::Object& object = s.objects.at(record.root);
    add_instance(s.device, s.scene, record, object.scene, s.ids.instances.size());
    s.ids.instances.push_back({&object.ids, record.first_id});
  }
  commit(s.scene);
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
