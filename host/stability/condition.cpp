#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/hash.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "stability/checks.h"
#include "stability/deviation.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

constexpr double kUlp = 1.0 / (1 << 23);  // of a float, relative

/// A random sign for each number, by its place in the scene.
class Signs {
 public:
  explicit Signs(std::uint64_t seed) : seed_(seed) {}
  double next() { return uniform64(seed_, 0, counter_++) < 0.5 ? -1 : 1; }

 private:
  std::uint64_t seed_, counter_ = 0;
};

void move(glm::dmat4& m, Signs& signs) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) m[column][row] *= 1 + kUlp * signs.next();
  }
}

void move(std::vector<Entity>& entities, Signs& signs) {
  for (Entity& entity : entities) {
    for (auto& [name, entry] : entity.parameters.entries) {
      if (auto* values = std::get_if<std::vector<double>>(&entry.value)) {
        for (double& v : *values) v *= 1 + kUlp * signs.next();
      }
    }
  }
}

/// Every number up or down by one float ulp: vertices, transforms, camera, lights, materials.
Scene moved(const Scene& scene, std::uint64_t seed) {
  Scene other = scene;
  Signs signs(seed);
  for (TriangleMesh& mesh : other.meshes) {
    for (glm::vec3& p : mesh.positions) {
      for (int k = 0; k < 3; ++k)
        p[k] = std::nextafter(
            p[k], signs.next() < 0 ? -std::numeric_limits<float>::max() : std::numeric_limits<float>::max());
    }
  }
  for (Shape& shape : other.shapes) {
    move(shape.to_world, signs);
    shape.radius *= 1 + kUlp * signs.next();
  }
  move(other.camera.camera_to_world, signs);
  for (auto* entities : {&other.lights, &other.area_lights, &other.materials}) move(*entities, signs);
  return other;
}

Check run(const std::string& name, const Job& job, const Workshop& workshop) {
  const auto start = std::chrono::steady_clock::now();
  const ImageCase c{
      .group = "condition", .name = name, .what = "", .scene = room_camera() + world(room()), .job = job};
  const Scene scene = read_case(c, workshop);
  const Scene other = moved(scene, 31);
  const auto on_device = [&](const Scene& s) {
    return Renderer(s, renderer_options(job, workshop)).render(job).image;
  };
  const auto in_double = [&](const Scene& s) { return Reference(s).render(job).image; };
  const Deviation device = deviation(on_device(other), on_device(scene), 1e-4);
  const Deviation truth = deviation(in_double(other), in_double(scene), 1e-4);
  Check check;
  check.group = "condition";
  check.name = name;
  check.what = "every number of the scene moved by one float ulp";
  check.values = device.pixels;
  check.non_finite = device.non_finite;
  check.largest = device.largest;
  check.beyond = device.beyond;
  check.measured =
      fmt::format("median {:.1e} (in double {:.1e}), {} beyond 1e-4 (in double {}), mean {:+.1e}",
                  device.median, truth.median, device.beyond, truth.beyond, device.bias);
  check.bound =
      "median at most 1e-5 or twice what it is in double; beyond 1e-4 half a percent more than in double";
  check.reason =
      "the image itself moves so far when a light path or a ray goes past the other side of an edge: the "
      "problem's own condition; more would be the program's";
  const auto pixels = static_cast<double>(device.pixels);
  check.passed = device.non_finite == 0 && device.median <= std::max(1e-5, 2 * truth.median) &&
                 static_cast<double>(device.beyond) <= static_cast<double>(truth.beyond) + 0.005 * pixels &&
                 std::abs(device.bias) <= 1e-3 + 2 * std::abs(truth.bias);
  check.command = command_of(path_of(c, workshop), job);
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

}  // namespace

std::vector<Task> condition_tasks(const Workshop& workshop) {
  std::vector<Task> tasks;
  const auto add = [&](const std::string& name, const Job& job) {
    tasks.push_back({"condition", name, [=] { return run(name, job, workshop); }});
  };
  add("ao-one-ulp", occlusion(1.5));
  add("direct-one-ulp", direct());
  add("igi-one-ulp", igi());
  return tasks;
}

}  // namespace capcon::stability
