#include "reference/light_paths.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "reference/unit_point.h"
#include "sampling/choice.h"
#include "shading/spectrum.h"

namespace capcon::reference {
namespace {

using glm::dot;
using glm::dvec3;

constexpr std::uint32_t kSeed = 0x70617468;
constexpr std::uint32_t kPairsOfASet = 65536;
constexpr std::uint32_t kMostHits = 1000;
constexpr double kMostLikely = 63.0 / 64;

// Dimension pairs. The bounce, 0 at the light, stands in for a pixel.
constexpr std::uint32_t kOriginPair = 0, kEmissionPair = 1;
constexpr std::uint32_t kGoingOnPair = 1, kDirectionPair = 3;  // pair 0 has the same order at every bounce

/// Where a path goes on from a hit, and what becomes of its flux, all kinds of chance but going on included.
struct Scattered {
  dvec3 direction;
  dvec3 factor;
};

std::optional<Scattered> scatter(const VirtualLight& y, const Bsdf& bsdf, const glm::dvec2& point,
                                 double choice) {
  const dvec3& a = y.arriving;
  const Frame frame(normal_seen_from(a, y.shading_normal, y.normal));
  const dvec3 from = frame.to_local(a);
  const std::optional<dvec3> local = bsdf.sample(from, point, choice);
  if (!local) return {};
  dvec3 direction = glm::normalize(frame.to_world(*local));
  const double pdf = bsdf.pdf(*local, from);
  // Directions above the shading normal alone are of no use, those above the geometric one alone would never
  // be found: they are each other's opposites.
  if (dot(direction, y.normal) < 0) direction = -direction;
  const double leaving = dot(direction, y.normal);
  if (!(leaving > 0 && pdf > 0)) return {};
  const Frame seen(normal_seen_from(direction, y.shading_normal, y.normal));
  const dvec3 in = seen.to_local(a), out = seen.to_local(direction);
  if (!(in.z > 0)) return {};
  return Scattered{direction, bsdf.evaluate(in, out) * (in.z / dot(a, y.normal) * leaving / pdf)};
}

}  // namespace

LightPaths::LightPaths(const Scene& scene, const Geometry& geometry, const DirectLighting& lighting,
                       const GlobalIlluminationJob& job)
    : geometry_(geometry),
      vertices_(lighting.vertices()),
      emission_(scene, geometry, lighting.lights()),
      scene_name_(scene.name),
      paths_(job.paths),
      sets_(job.sets),
      partition_(job.partition),
      seed_(job.direct.seed ^ kSeed) {
  sampler_ = partition_ ? make_sampler(job.sampler, paths_ * sets_, seed_, sets_)
                        : make_sampler(job.sampler, paths_, seed_);
}

FixedPoint LightPaths::point(std::uint32_t set, std::uint32_t index, std::uint32_t bounce, std::uint32_t pair,
                             SampleDomain domain) const {
  index = path_point(seed_, set, index, paths_, bounce, pair);
  if (partition_) return sampler_->sample(bounce, set * paths_ + index, pair, domain);
  return sampler_->sample(bounce, index, pair + kPairsOfASet * set, domain);
}

double LightPaths::choice(std::uint32_t set, std::uint32_t index, std::uint32_t bounce) const {
  Split split;
  split.parts = sets_;
  split.points = paths_;
  return unit_point({component_choice(seed_, bounce, set, index, split, !partition_), 0}).x;
}

std::vector<VirtualLight> LightPaths::path(std::uint32_t set, std::uint32_t index) const {
  const FixedPoint origin = point(set, index, 0, kOriginPair, emission_.origin_domain());
  const glm::dvec2 towards = unit_point(point(set, index, 0, kEmissionPair, emission_.direction_domain()));
  const std::optional<EmissionRay> start = emission_.start(origin, towards, choice(set, index, 0));
  std::vector<VirtualLight> hits;
  if (!start) return hits;
  Ray ray(start->origin, start->direction);
  Ignored ignored = start->ignored;
  dvec3 flux = start->flux / static_cast<double>(paths_);
  for (std::uint32_t bounce = 1; bounce <= kMostHits; ++bounce) {
    const std::optional<Seen> seen = geometry_.look(ray, ignored);
    if (!seen) break;
    const ShadingPoint surface = vertices_.surfaces().at(seen->primitive, seen->at);
    const VirtualLight y{seen->at.position,
                         seen->at.normal,
                         turned_normal(surface, seen->at.normal),
                         -ray.direction,
                         flux,
                         surface.uv,
                         surface.material,
                         seen->primitive,
                         index,
                         bounce};
    if (!(dot(y.arriving, y.normal) > 0)) break;  // edge on
    hits.push_back(y);
    const glm::dvec2 u = unit_point(point(set, index, bounce, kDirectionPair, SampleDomain::disk));
    const std::optional<Scattered> next =
        scatter(y, vertices_.bsdfs().at(y.material, y.uv), u, choice(set, index, bounce));
    if (!next) break;
    const double goes_on = std::min(luminance(next->factor), kMostLikely);
    if (!(unit_point(point(set, index, bounce, kGoingOnPair, SampleDomain::square)).x < goes_on)) break;
    flux *= next->factor / goes_on;
    ray = Ray(y.position, next->direction);
    ignored = {seen->ignored};
  }
  return hits;
}

VirtualLights LightPaths::all() const {
  std::vector<std::vector<VirtualLight>> paths(std::size_t(paths_) * sets_);
  parallel_for(
      paths.size(),
      [&](std::size_t i) {
        paths[i] = path(static_cast<std::uint32_t>(i / paths_), static_cast<std::uint32_t>(i % paths_));
      },
      64);
  VirtualLights result;
  for (std::uint32_t set = 0; set < sets_; ++set) {
    for (std::size_t i = std::size_t(set) * paths_; i < std::size_t(set + 1) * paths_; ++i)
      result.lights.insert(result.lights.end(), paths[i].begin(), paths[i].end());
    std::stable_sort(result.lights.begin() + result.first.back(), result.lights.end(),
                     [](const VirtualLight& a, const VirtualLight& b) { return a.bounce < b.bounce; });
    result.first.push_back(static_cast<std::uint32_t>(result.lights.size()));
  }
  if (result.lights.empty())
    throw InputError(scene_name_ +
                     ": no light path hits a surface; turn the lights to the scene, or trace more paths");
  return result;
}

}  // namespace capcon::reference
