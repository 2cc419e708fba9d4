#include "bench/geometry_triangles.h"

#include <algorithm>
#include <bit>
#include <glm/vec4.hpp>
#include <limits>

#include "layout.h"

namespace capcon {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Index of an id, or kNone.
std::uint32_t find(const TriangleSlots& triangles, std::uint32_t id) {
  const auto at = std::lower_bound(triangles.ids.begin(), triangles.ids.end(), id);
  if (at == triangles.ids.end() || *at != id) return kNone;
  return static_cast<std::uint32_t>(at - triangles.ids.begin());
}

}  // namespace

TriangleSlots triangle_slots(const Geometry& geometry, std::uint32_t root) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;  // id, slot
  std::vector<std::uint32_t> waiting{root};
  while (!waiting.empty()) {
    const std::size_t node = waiting.back();
    waiting.pop_back();
    const glm::uvec4 links = geometry.bvh.texels[4 * node + 3];
    const int inner = std::popcount(links.x & 15u);
    for (int k = 0; k < inner; ++k) waiting.push_back((links.x >> 4) + k);
    for (std::uint32_t leaf : {links.z & 0xffffu, links.z >> 16, links.w & 0xffffu, links.w >> 16}) {
      for (; leaf != 0; leaf &= leaf - 1) {
        const std::uint32_t slot = links.y + std::countr_zero(leaf), id = geometry.primitives[3 * slot].w;
        if ((id & layout::kQuadricBit) == 0) found.emplace_back(id, slot);
      }
    }
  }
  std::sort(found.begin(), found.end());
  TriangleSlots triangles;
  triangles.ids.reserve(found.size());
  triangles.slots.reserve(found.size());
  for (const auto& [id, slot] : found) {
    if (!triangles.ids.empty() && triangles.ids.back() == id) continue;
    triangles.ids.push_back(id);
    triangles.slots.push_back(slot);
  }
  return triangles;
}

std::array<glm::vec3, 3> triangle_in_slot(const Geometry& geometry, std::uint32_t slot) {
  std::array<glm::vec3, 3> vertices;
  for (int k = 0; k < 3; ++k) {
    const glm::uvec4 w = geometry.primitives[3 * std::size_t(slot) + k];
    vertices[k] = {std::bit_cast<float>(w.x), std::bit_cast<float>(w.y), std::bit_cast<float>(w.z)};
  }
  return vertices;
}

InstanceRecord instance_record(const Geometry& geometry, std::size_t instance) {
  const glm::uvec4* texels = &geometry.instances[8 * instance];
  InstanceRecord record;
  record.root = texels[3].w & ~layout::kWorldInstance;
  record.world = (texels[3].w & layout::kWorldInstance) != 0;
  record.first_id = texels[4].w;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column)
      record.to_world[4 * row + column] = std::bit_cast<float>(texels[5 + row][column]);
  }
  return record;
}

TriangleLookup::TriangleLookup(const Geometry& geometry) : geometry_(geometry), world_root_(kNone) {
  if (geometry.instances.empty()) {
    world_root_ = 0;
    trees_.emplace(0, triangle_slots(geometry, 0));
    return;
  }
  for (std::size_t i = 0; i < geometry.instance_count(); ++i) {
    const InstanceRecord record = instance_record(geometry, i);
    if (!trees_.contains(record.root)) trees_.emplace(record.root, triangle_slots(geometry, record.root));
    if (record.world) {
      world_root_ = record.root;
    } else {
      instances_.push_back(record);
    }
  }
  std::sort(instances_.begin(), instances_.end(),
            [](const InstanceRecord& a, const InstanceRecord& b) { return a.first_id < b.first_id; });
}

std::array<glm::dvec3, 3> TriangleLookup::vertices(std::uint32_t id) const {
  if (world_root_ != kNone) {
    const TriangleSlots& world = trees_.at(world_root_);
    if (const std::uint32_t at = find(world, id); at != kNone) {
      const auto v = triangle_in_slot(geometry_, world.slots[at]);
      return {v[0], v[1], v[2]};
    }
  }
  const auto after =
      std::upper_bound(instances_.begin(), instances_.end(), id,
                       [](std::uint32_t value, const InstanceRecord& i) { return value < i.first_id; });
  const InstanceRecord& instance = *(after - 1);
  const TriangleSlots& object = trees_.at(instance.root);
  const auto v = triangle_in_slot(geometry_, object.slots[find(object, id - instance.first_id)]);
  std::array<glm::dvec3, 3> moved;
  for (int k = 0; k < 3; ++k) {
    for (int row = 0; row < 3; ++row) {
      const float* r = &instance.to_world[4 * row];
      moved[k][row] = double(r[0]) * v[k].x + double(r[1]) * v[k].y + double(r[2]) * v[k].z + r[3];
    }
  }
  return moved;
}

}  // namespace capcon
