#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/known_parameters.h"
#include "scene/pbrt_directives.h"
#include "scene/pbrt_parameters.h"
#include "scene/suggestion.h"
#include "scene/tessellate.h"

namespace capcon {
namespace {

const std::vector<std::string_view> kLeftOut = {"cylinder",    "cone",         "paraboloid",
                                                "hyperboloid", "curve",        "nurbs",
                                                "heightfield", "heightfield2", "bilinearmesh"};
const std::vector<std::string_view> kKnown = {
    "trianglemesh", "plymesh",     "objmesh", "sphere", "disk",        "loopsubdiv",   "cylinder",    "cone",
    "paraboloid",   "hyperboloid", "curve",   "nurbs",  "heightfield", "heightfield2", "bilinearmesh"};

/// The parameters of one Shape directive.
struct ShapeSource {
  const Parameters& parameters;
  SourcePlace place;

  const Parameters::Entry* entry(const std::string& name) const {
    const auto found = parameters.entries.find(name);
    return found == parameters.entries.end() ? nullptr : &found->second;
  }
  SourcePlace place_of(const std::string& name) const { return entry(name) ? entry(name)->place : place; }
};

template <int n, typename Vector>
std::vector<Vector> vectors(const ShapeSource& source, const std::string& name) {
  std::vector<Vector> result;
  const std::vector<double>* numbers = source.parameters.numbers(name);
  if (!numbers) return result;
  if (numbers->size() % n != 0)
    throw InputError(source.place_of(name), fmt::format("\"{}\" must hold {} numbers a vertex", name, n));
  result.reserve(numbers->size() / n);
  for (std::size_t i = 0; i < numbers->size(); i += n) {
    Vector vector;
    for (int k = 0; k < n; ++k) {
      vector[k] = static_cast<float>((*numbers)[i + k]);
      if (!std::isfinite(vector[k])) {
        throw InputError(source.place_of(name),
                         fmt::format("\"{}\" number {} is too large for a float", name, i + k));
      }
    }
    result.push_back(vector);
  }
  return result;
}

std::vector<glm::uvec3> triangles(const ShapeSource& source, std::size_t vertices) {
  const std::vector<double>* indices = source.parameters.numbers("indices");
  if (!indices) {
    if (vertices == 3) return {{0, 1, 2}};  // pbrt-v4's short form of one triangle
    throw InputError(source.place, "this mesh has no \"integer indices\"");
  }
  const SourcePlace place = source.place_of("indices");
  if (indices->size() % 3 != 0) {
    throw InputError(place, fmt::format("\"integer indices\" has {} numbers, which is not a multiple of 3",
                                        indices->size()));
  }
  std::vector<glm::uvec3> result(indices->size() / 3);
  for (std::size_t i = 0; i < indices->size(); ++i) {
    const double index = (*indices)[i];
    if (!(index >= 0 && index < static_cast<double>(vertices) && index == std::floor(index))) {
      throw InputError(
          place, fmt::format("number {} of \"integer indices\" is {}, but the vertices are numbered 0 to {}",
                             i, index, static_cast<long long>(vertices) - 1));
    }
    result[i / 3][i % 3] = static_cast<std::uint32_t>(index);
  }
  return result;
}

/// "trianglemesh", and the control mesh of "loopsubdiv".
TriangleMesh triangle_mesh(const ShapeSource& source, const ReadOptions& options) {
  if (!source.entry("P")) throw InputError(source.place, "this mesh has no \"point P\"");
  TriangleMesh mesh;
  mesh.positions = vectors<3, glm::vec3>(source, "P");
  if (mesh.positions.size() >= std::numeric_limits<std::uint32_t>::max())
    throw InputError(source.place, "a mesh has fewer than 2^32 vertices");
  mesh.triangles = triangles(source, mesh.positions.size());
  const std::string uv = source.entry("uv") ? "uv" : "st";
  if (options.normals) mesh.normals = vectors<3, glm::vec3>(source, "N");
  if (options.uvs) mesh.uvs = vectors<2, glm::vec2>(source, uv);
  const auto check = [&](const std::string& name, std::size_t count) {
    if (count != 0 && count != mesh.positions.size()) {
      throw InputError(source.place_of(name), fmt::format("\"{}\" is given for {} vertices, but \"P\" for {}",
                                                          name, count, mesh.positions.size()));
    }
  };
  check("N", mesh.normals.size());
  check(uv, mesh.uvs.size());
  return mesh;
}

double positive(const ShapeSource& source, const std::string& name, double fallback) {
  const double value = source.parameters.number(name, fallback);
  if (value > 0 && value < 1e18) return value;
  throw InputError(source.place_of(name), fmt::format("{} must be greater than 0 and less than 1e18", name));
}

double phi_max(const ShapeSource& source) {
  return std::min(positive(source, "phimax", 360), 360.0);
}

std::uint32_t add_mesh(Scene& scene, TriangleMesh mesh) {
  scene.meshes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(scene.meshes.size() - 1);
}

void sphere(const ShapeSource& source, Scene& scene, Shape& shape) {
  shape.kind = ShapeKind::sphere;
  shape.radius = positive(source, "radius", 1);
  const double z_a = std::clamp(source.parameters.number("zmin", -shape.radius), -shape.radius, shape.radius);
  const double z_b = std::clamp(source.parameters.number("zmax", shape.radius), -shape.radius, shape.radius);
  const double z_min = std::min(z_a, z_b), z_max = std::max(z_a, z_b);
  if (phi_max(source) == 360 && z_min == -shape.radius && z_max == shape.radius) return;
  shape.kind = ShapeKind::mesh;
  shape.mesh = add_mesh(scene, tessellate_sphere(shape.radius, z_min, z_max, phi_max(source)));
}

void disk(const ShapeSource& source, Scene& scene, Shape& shape) {
  shape.kind = ShapeKind::disk;
  shape.radius = positive(source, "radius", 1);
  shape.height = source.parameters.number("height", 0);
  shape.inner_radius = source.parameters.number("innerradius", 0);
  if (!(shape.inner_radius >= 0 && shape.inner_radius < shape.radius)) {
    throw InputError(source.place_of("innerradius"),
                     "innerradius must be 0 or more and less than the radius");
  }
  if (phi_max(source) == 360) return;
  shape.kind = ShapeKind::mesh;
  shape.mesh =
      add_mesh(scene, tessellate_disk(shape.radius, shape.inner_radius, shape.height, phi_max(source)));
}

/// False when there is no such file: scenes are handed on without their largest meshes, and pbrt renders them
/// too.
bool mesh_file(const ShapeSource& source, PbrtContext& context, Shape& shape, const std::string& type) {
  const std::string name = source.parameters.string("filename", {});
  if (name.empty()) throw InputError(source.place, fmt::format("a {} needs its \"string filename\"", type));
  const SourcePlace place = source.place_of("filename");
  const std::filesystem::path path = context.resolve(name, place);
  const std::string wanted = type == "plymesh" ? ".ply" : ".obj";
  if (path.extension() != wanted) {
    throw InputError(place, fmt::format("a {} is read from a {} file, not from \"{}\"", type, wanted, name));
  }
  const std::optional<std::uint32_t> mesh = context.files.add(path, context.scene.meshes);
  if (mesh) {
    shape.mesh = *mesh;
  } else {
    context.warn(place,
                 fmt::format("the mesh file \"{}\" cannot be found; its shape was left out", path.string()));
  }
  return mesh.has_value();
}

/// Puts the shape into the open object or into the world.
void add_shape(PbrtContext& context, Shape shape, bool hidden) {
  if (!context.object) {
    (hidden ? context.scene.hidden_shapes : context.scene.shapes).push_back(std::move(shape));
    return;
  }
  if (shape.area_light >= 0) {
    context.warn(shape.place, "area lights in objects are left out: instances do not emit");
    shape.area_light = -1;
  }
  if (!hidden) context.scene.objects[*context.object].shapes.push_back(std::move(shape));
}

/// Whether an alpha of 0 hides the shape. Cut-outs by textures are not supported.
bool is_hidden(PbrtContext& context, const ShapeSource& source) {
  const Parameters::Entry* alpha = source.entry("alpha");
  if (!alpha) return false;
  if (alpha->type == "float") return source.parameters.number("alpha", 1) == 0;
  context.warn(alpha->place, "alpha textures are left out: the shapes that have one are opaque");
  return false;
}

std::vector<std::string_view> unneeded(const PbrtContext& context) {
  const ReadOptions& options = context.options;
  std::vector<std::string_view> names;
  if (!context.notes) names = {"S"};
  if (!options.normals) names.push_back("N");
  if (!options.uvs) names.insert(names.end(), {"uv", "st"});
  return names;
}

}  // namespace

void read_pbrt_shape(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const SourcePlace place = tokens.place(directive);
  const std::string type = read_string(tokens, "Shape");
  if (std::find(kKnown.begin(), kKnown.end(), type) == kKnown.end()) {
    throw InputError(place, fmt::format("unknown shape \"{}\"{}", type, suggestion(type, kKnown)));
  }
  Parameters parameters = read_parameters(tokens, unneeded(context));
  const auto defaults = context.state.defaults.find("shape");
  if (defaults != context.state.defaults.end())
    parameters.entries.insert(defaults->second.entries.begin(), defaults->second.entries.end());
  if (std::find(kLeftOut.begin(), kLeftOut.end(), type) != kLeftOut.end()) {
    context.warn(place, fmt::format("shape \"{}\" is not supported and was left out", type));
    return;
  }
  note_parameters(context, "Shape", type, parameters);
  const ShapeSource source{parameters, place};
  Shape shape;
  shape.to_world = context.state.to_world;
  shape.reverse_orientation = context.state.reverse_orientation;
  shape.material = context.state.material;
  shape.area_light = context.state.area_light;
  shape.place = place;
  if (type == "sphere") {
    sphere(source, context.scene, shape);
  } else if (type == "disk") {
    disk(source, context.scene, shape);
  } else if (type == "plymesh" || type == "objmesh") {
    if (!mesh_file(source, context, shape, type)) return;
  } else {
    if (type == "loopsubdiv")
      context.warn(place, "subdivision surfaces are not refined: their control meshes are used");
    shape.mesh = add_mesh(context.scene, triangle_mesh(source, context.options));
  }
  add_shape(context, std::move(shape), is_hidden(context, source));
}

}  // namespace capcon
