#include "generator/assembly.h"

#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "generator/compact.h"
#include "generator/normals.h"
#include "generator/ply.h"

namespace capcon::scenes {

void Assembly::define(const std::string& name, Model model, double crease) {
  for (Model::Part& part : model.parts) {
    compact(part.mesh);
    if (crease > 0) add_normals(part.mesh, crease);
  }
  std::erase_if(model.parts, [](const Model::Part& part) { return part.mesh.triangles.empty(); });
  if (!entries_.emplace(name, Entry{std::move(model), {}}).second) {
    throw Failure(fmt::format("two models of scene {} are called {}", name_, name));
  }
}

void Assembly::place(const std::string& name, const Matrix& where) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) throw Failure(fmt::format("scene {} has no model called {}", name_, name));
  found->second.places.push_back(where);
}

void Assembly::add(const std::string& name, Model model, const Matrix& where, double crease) {
  define(name, std::move(model), crease);
  place(name, where);
}

void Assembly::repeat(int nx, int ny, const Vec2& step) {
  for (auto& [name, entry] : entries_) {
    const std::vector<Matrix> once = std::exchange(entry.places, {});
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        for (const Matrix& where : once) entry.places.push_back(translate(step.x * x, step.y * y, 0) * where);
      }
    }
  }
}

std::uint64_t Assembly::unique_triangles() const {
  std::uint64_t count = 0;
  for (const auto& [name, entry] : entries_) {
    for (const Model::Part& part : entry.model.parts) count += part.mesh.triangles.size();
  }
  return count;
}

std::uint64_t Assembly::instanced_triangles() const {
  std::uint64_t count = 0;
  for (const auto& [name, entry] : entries_) {
    for (const Model::Part& part : entry.model.parts)
      count += part.mesh.triangles.size() * entry.places.size();
  }
  return count;
}

std::string Assembly::part_file(const std::string& model, const std::string& material) const {
  return fmt::format("{}-{}-{}.ply", name_, model, material);
}

namespace {
std::string transform_text(const Matrix& m) {
  if (m == Matrix(1)) return {};
  std::string text = "  Transform [";
  for (int k = 0; k < 16; ++k) text += fmt::format(" {:.9g}", glm::value_ptr(m)[k] + 0.0);
  return text + " ]\n";
}
}  // namespace

std::string Assembly::shapes_text() const {
  std::string text = fmt::format(
      "# Geometry of {}.pbrt, written by scenes/generator: {} triangles, {} with all instances.\n", name_,
      unique_triangles(), instanced_triangles());
  for (const auto& [name, entry] : entries_) {
    const bool object = entry.places.size() != 1;
    text += object ? fmt::format("ObjectBegin \"{}\"\n", name)
                   : "AttributeBegin\n" + transform_text(entry.places[0]);
    for (const Model::Part& part : entry.model.parts) {
      text +=
          fmt::format("  NamedMaterial \"{}\"\n  Shape \"plymesh\" \"string filename\" [ \"geometry/{}\" ]\n",
                      part.material, part_file(name, part.material));
    }
    text += object ? "ObjectEnd\n" : "AttributeEnd\n";
  }
  for (const auto& [name, entry] : entries_) {
    if (entry.places.size() == 1) continue;
    for (const Matrix& where : entry.places) {
      text += fmt::format("AttributeBegin\n{}  ObjectInstance \"{}\"\nAttributeEnd\n", transform_text(where),
                          name);
    }
  }
  return text;
}

void Assembly::write(const std::filesystem::path& folder) const {
  for (const auto& [name, entry] : entries_) {
    for (const Model::Part& part : entry.model.parts) {
      write_file(folder / part_file(name, part.material), ply_bytes(part.mesh));
    }
  }
  write_file(folder / (name_ + "-shapes.pbrt"), shapes_text());
}

}  // namespace capcon::scenes
