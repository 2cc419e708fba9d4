#include "scene/ply_reader.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "scene/ply_header.h"
#include "scene/ply_values.h"

namespace capcon {
namespace {

/// The numbers of a vertex that we know.
enum Slot { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kSlots };
constexpr int kNone = -1;

int slot_of(const std::string& name) {
  static constexpr struct {
    std::string_view name;
    Slot slot;
  } kNames[] = {{"x", kX},   {"y", kY},         {"z", kZ},         {"nx", kNx},       {"ny", kNy},
                {"nz", kNz}, {"u", kU},         {"s", kU},         {"texture_u", kU}, {"v", kV},
                {"t", kV},   {"texture_v", kV}, {"texture_s", kU}, {"texture_t", kV}};
  for (const auto& known : kNames) {
    if (known.name == name) return known.slot;
  }
  return kNone;
}

/// What is read of the vertices, and which slot each property fills.
struct VertexPlan {
  std::vector<int> slots;  ///< one a property
  bool normals = false;
  bool uvs = false;
};

VertexPlan plan_vertices(const PlyElement& element, const ReadOptions& options, const std::string& name) {
  VertexPlan plan;
  std::array<bool, kSlots> found{};
  for (const PlyProperty& property : element.properties) {
    int slot = property.is_list ? kNone : slot_of(property.name);
    if (slot != kNone && found[slot]) slot = kNone;  // u and s: the first counts
    if (slot != kNone) found[slot] = true;
    plan.slots.push_back(slot);
  }
  if (!found[kX] || !found[kY] || !found[kZ]) {
    throw InputError(fmt::format("{}: the PLY element \"vertex\" needs the properties x, y and z", name));
  }
  plan.normals = options.normals && found[kNx] && found[kNy] && found[kNz];
  plan.uvs = options.uvs && found[kU] && found[kV];
  for (int& slot : plan.slots) {
    if ((slot >= kNx && slot <= kNz && !plan.normals) || (slot >= kU && !plan.uvs)) slot = kNone;
  }
  return plan;
}

template <typename Values>
std::uint64_t read_count(Values& values, PlyType type) {
  const double count = values.read(type);
  if (!(count >= 0 && count == std::floor(count) && count <= 0xFFFFFFFFu)) {
    throw PlyFault{fmt::format("{} is not the length of a list", count)};
  }
  return static_cast<std::uint64_t>(count);
}

template <typename Values>
void skip_property(Values& values, const PlyProperty& property) {
  std::uint64_t count = 1;
  if (property.is_list) count = read_count(values, property.count_type);
  for (std::uint64_t i = 0; i < count; ++i) values.skip(property.type);
}

template <typename Values>
void read_vertex(Values& values, const PlyElement& element, const VertexPlan& plan, TriangleMesh& mesh) {
  std::array<float, kSlots> vertex{};
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (plan.slots[i] == kNone) {
      skip_property(values, property);
      continue;
    }
    vertex[plan.slots[i]] = static_cast<float>(values.read(property.type));
    if (!std::isfinite(vertex[plan.slots[i]])) throw PlyFault{property.name + " is not a finite number"};
  }
  mesh.positions.emplace_back(vertex[kX], vertex[kY], vertex[kZ]);
  if (plan.normals) mesh.normals.emplace_back(vertex[kNx], vertex[kNy], vertex[kNz]);
  if (plan.uvs) mesh.uvs.emplace_back(vertex[kU], vertex[kV]);
}

/// One corner; whether the vertex exists is checked at the end, for the faces may come first.
template <typename Values>
std::uint32_t read_corner(Values& values, PlyType type) {
  const double index = values.read(type);
  if (!(index >= 0 && index == std::floor(index) && index < 0xFFFFFFFFu)) {
    throw PlyFault{fmt::format("{} is not the number of a vertex", index)};
  }
  return static_cast<std::uint32_t>(index);
}

template <typename Values>
void read_face(Values& values, const PlyElement& element, std::size_t corners, TriangleMesh& mesh) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (i != corners) {
      skip_property(values, property);
      continue;
    }
    const std::uint64_t count = read_count(values, property.count_type);
    if (count < 3) throw PlyFault{fmt::format("a face needs 3 corners or more, this has {}", count)};
    const std::uint32_t first = read_corner(values, property.type);
    std::uint32_t previous = read_corner(values, property.type);
    for (std::uint64_t corner = 2; corner < count; ++corner) {
      const std::uint32_t next = read_corner(values, property.type);
      mesh.triangles.emplace_back(first, previous, next);
      previous = next;
    }
  }
}

std::size_t corner_property(const PlyElement& element, const std::string& name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index")) return i;
  }
  throw InputError(fmt::format("{}: the PLY element \"face\" needs a list property vertex_indices", name));
}

/// Calls read() for each record; a fault gets the record's number.
template <typename Read>
void each_record(const PlyElement& element, const std::string& name, const Read& read) {
  for (std::uint64_t i = 0; i < element.count; ++i) {
    try {
      read();
    } catch (const PlyFault& fault) {
      throw InputError(fmt::format("{}: {} {}: {}", name, element.name, i, fault.what));
    }
  }
}

template <typename Values>
TriangleMesh read_elements(Values values, const PlyHeader& header, const std::string& name,
                           const ReadOptions& options) {
  TriangleMesh mesh;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      const VertexPlan plan = plan_vertices(element, options, name);
      if (element.count >= std::numeric_limits<std::uint32_t>::max()) {
        throw InputError(fmt::format("{}: a mesh has fewer than 2^32 vertices", name));
      }
      mesh.positions.reserve(element.count);
      each_record(element, name, [&] { read_vertex(values, element, plan, mesh); });
    } else if (element.name == "face") {
      const std::size_t corners = corner_property(element, name);
      mesh.triangles.reserve(element.count);
      each_record(element, name, [&] { read_face(values, element, corners, mesh); });
    } else {
      each_record(element, name, [&] {
        for (const PlyProperty& property : element.properties) skip_property(values, property);
      });
    }
  }
  return mesh;
}

void check_elements(const PlyHeader& header, const std::string& name) {
  for (const char* wanted : {"vertex", "face"}) {
    int found = 0;
    for (const PlyElement& element : header.elements) found += element.name == wanted;
    if (found != 1) {
      throw InputError(
          fmt::format("{}: a PLY mesh has one element \"{}\", this file has {}", name, wanted, found));
    }
  }
}

}  // namespace

TriangleMesh parse_ply(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const PlyHeader header = parse_ply_header(bytes, name);
  check_elements(header, name);
  const std::string_view data = bytes.substr(header.data_start);
  TriangleMesh mesh = header.format == PlyFormat::ascii
                          ? read_elements(PlyTextValues(data), header, name, options)
                          : read_elements(PlyBinaryValues(data, header.format == PlyFormat::big_endian),
                                          header, name, options);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      if (mesh.triangles[i][corner] < mesh.positions.size()) continue;
      throw InputError(fmt::format("{}: triangle {} names vertex {}, but there are only {}", name, i,
                                   mesh.triangles[i][corner], mesh.positions.size()));
    }
  }
  return mesh;
}

}  // namespace capcon
