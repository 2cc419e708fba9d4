#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

#include "render/geometry.h"

namespace capcon {

/// The triangles below one node of a Geometry, each once where it lies in several leaves, in ascending order
/// of their ids. With two levels `root` must be that of an object's tree, and the ids are those within the
/// object.
struct TriangleSlots {
  std::vector<std::uint32_t> ids, slots;
};
TriangleSlots triangle_slots(const Geometry& geometry, std::uint32_t root);

/// Vertices of the triangle in a slot, in the space of its tree.
std::array<glm::vec3, 3> triangle_in_slot(const Geometry& geometry, std::uint32_t slot);

/// An instance of a Geometry with two levels: its eight texels by name.
struct InstanceRecord {
  std::uint32_t root = 0, first_id = 0;
  bool world = false;              ///< what is in no object: nothing is transformed
  std::array<float, 12> to_world;  ///< three rows of object-to-world
};
InstanceRecord instance_record(const Geometry& geometry, std::size_t instance);

/// Finds triangles by the ids that rays meet (render/ray_caster.h).
class TriangleLookup {
 public:
  explicit TriangleLookup(const Geometry& geometry);
  /// Vertices in the device's space; `id` must be a triangle's.
  std::array<glm::dvec3, 3> vertices(std::uint32_t id) const;

 private:
  const Geometry& geometry_;
  std::unordered_map<std::uint32_t, TriangleSlots> trees_;  // by root
  std::vector<InstanceRecord> instances_;                   // ascending first ids, without the world
  std::uint32_t world_root_ = 0;
};

}  // namespace capcon
