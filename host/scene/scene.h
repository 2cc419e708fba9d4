#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "image/image.h"

namespace capcon {

/// Geometry shared by shapes, in object space. Indices are checked against `positions` when it is read.
struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  std::vector<glm::vec3> normals;  ///< empty, or one a position
  std::vector<glm::vec2> uvs;      ///< empty, or one a position
};

/// A named parameter list of pbrt, kept as read: "type name" -> values.
struct Parameters {
  using Value = std::variant<std::vector<double>, std::vector<std::string>, std::vector<bool>>;
  struct Entry {
    std::string type;  ///< as written: float, rgb, color, spectrum, string, texture, point, ...
    Value value;
    SourcePlace place;
  };
  std::map<std::string, Entry> entries;

  /// First number of the entry, or `fallback` when absent. InputError (with its place) when it is not a
  /// number.
  double number(const std::string& name, double fallback) const;
  std::string string(const std::string& name, const std::string& fallback) const;
  bool boolean(const std::string& name, bool fallback) const;
  /// All numbers of the entry, nullptr when absent.
  const std::vector<double>* numbers(const std::string& name) const;
};

/// A directive with a type and parameters that later stages interpret: material, light, area light, texture.
struct Entity {
  std::string type;
  std::string name;  ///< of a named material or texture, else empty
  Parameters parameters;
  glm::dmat4 to_world{1};  ///< the current transform at the directive (lights)
  SourcePlace place;
  std::string values;  ///< of a texture: "float" or "spectrum", which pbrt names apart; else empty
  int image = -1;      ///< of an image texture or environment light: index into Scene::images, -1 for none
};

enum class ShapeKind : std::uint8_t { mesh, sphere, disk };

/// One shape under its transform. Spheres and disks are full: partial ones (phimax, zmin, zmax) are read as
/// meshes.
struct Shape {
  ShapeKind kind = ShapeKind::mesh;
  std::uint32_t mesh = 0;   ///< index into Scene::meshes
  double radius = 1;        ///< sphere, disk
  double height = 0;        ///< disk: z of its plane
  double inner_radius = 0;  ///< disk
  glm::dmat4 to_world{1};   ///< within an object: to the object's space
  bool reverse_orientation = false;
  int material = -1;    ///< index into Scene::materials, -1 for the default
  int area_light = -1;  ///< index into Scene::area_lights, -1 for none
  SourcePlace place;
};

struct Object {
  std::string name;
  std::vector<Shape> shapes;
};

struct Instance {
  std::uint32_t object = 0;  ///< index into Scene::objects
  glm::dmat4 to_world{1};
};

/// A perspective camera with pbrt's conventions: left-handed camera space, +x right, +y up, looking along +z.
struct Camera {
  glm::dmat4 camera_to_world{1};  ///< may mirror (Scale -1 1 1 before LookAt)
  double fov_degrees = 90;        ///< full angle across the shorter image axis
  std::array<double, 4> screen{
      0, 0, 0, 0};                ///< x_min, x_max, y_min, y_max; all 0: from the aspect ratio, as pbrt does
  double frame_aspect_ratio = 0;  ///< 0: from the resolution
};

struct Film {
  int width = 640;
  int height = 480;
  std::string filename;
};

/// The pixels of a texture or an environment map.
struct SceneImage {
  std::string file;
  Image image;
};

/// One flat scene: what a scene file says, with all files it names read, transforms applied down to objects.
struct Scene {
  std::string name;  ///< file name without folder and extension
  std::string
      folder;  ///< of the scene file: other files are named relative to it, or to the file that names them
  Film film;
  Camera camera;
  std::vector<TriangleMesh> meshes;
  std::vector<Shape> shapes;  ///< in world space, outside objects
  std::vector<Shape>
      hidden_shapes;  ///< of alpha 0, outside objects: they emit, yet no ray sees or meets them
  std::vector<Object> objects;
  std::vector<Instance> instances;
  std::vector<Entity> materials;
  std::vector<Entity> lights;
  std::vector<Entity> area_lights;
  std::vector<Entity> textures;
  std::vector<SceneImage> images;     ///< read only if ReadOptions asks for them, each file once
  std::vector<std::string> warnings;  ///< one sentence each, each thing once

  /// Triangles of all shapes (hidden ones too), those of an object once; spheres and disks have none.
  std::uint64_t unique_triangles() const;
  /// The same with the triangles of an object counted for each of its instances.
  std::uint64_t instanced_triangles() const;
};

/// What a job needs of a scene: what is not needed is not read.
struct ReadOptions {
  bool normals = false;
  bool uvs = false;
  bool images = false;  ///< the pixels of image textures and environment maps (EXR, PNG)
};

/// Reads .pbrt (v4 names; v2/v3 accepted), .ply or .obj by its extension. A bare mesh gets a camera that sees
/// it whole. InputError with file:line:column for anything malformed: unknown directives, missing includes,
/// bad numbers, NaN. What pbrt itself renders without (a missing mesh file, an undefined material) and what
/// is not supported (motion, media, shape alpha, some shapes) is said in `warnings`.
Scene read_scene(const std::string& path, const ReadOptions& options = {});

}  // namespace capcon
