#include "reference/global_illumination.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/hash.h"
#include "reference/unit_point.h"
#include "shading/spectrum.h"

namespace capcon::reference {
namespace {

using glm::dot;
using glm::dvec3;

constexpr std::uint32_t kSeed = 0x67617468;
constexpr std::uint32_t kMostSurfaces = 64;
/// How much of the way to a VPL is looked at.
constexpr double kWay = 1 - 0x1p-17;
constexpr double kLeastDistance2 = 1e-30;
/// How far two-sided VPLs are moved through their surface, of the scene's largest coordinate.
constexpr double kThickness = 0x1p-18;

// Dimension pairs; those of surfaces that compensation rays meet have 65536 of their own each.
constexpr std::uint32_t kBsdfPair = 0, kOnwardsPair = 1, kComponentPair = 2, kLightPairs = 3;
constexpr std::uint32_t kGoingOnPair = 65535;
constexpr std::uint32_t kPairsOfASurface = 65536;

/// The points of compensation rays are laid out as a pixel's integrator samples are: one part a set.
DirectLightingJob ray_points(const GlobalIlluminationJob& job) {
  DirectLightingJob rays = job.direct;
  rays.seed ^= kSeed;
  rays.integrator_samples = job.gather;
  if (job.direct.position == PixelPosition::centre) rays.image_samples = job.sets_a_pixel();
  rays.position = PixelPosition::centre;  // no points in the pixel
  rays.partition = true;
  return rays;
}

/// (a . n) / (a . n_g) of the shading normal n; 0 where a is not above both.
double ratio_of(const VirtualLight& y) {
  const double cosine = dot(y.arriving, y.shading_normal), geometric = dot(y.arriving, y.normal);
  return cosine > 0 && geometric > 0 ? cosine / geometric : 0;
}

}  // namespace

GlobalIllumination::GlobalIllumination(const Geometry& geometry, const DirectLighting& lighting,
                                       const GlobalIlluminationJob& job, const VirtualLights& lights,
                                       int width)
    : geometry_(geometry),
      lighting_(lighting),
      job_(job),
      points_(job.direct, width),
      first_(lights.first),
      limit_(job.clamping == Clamping::none ? std::numeric_limits<double>::infinity() : job.limit) {
  assert(lights.sets() == job.sets && limit_ > 0);
  for (VirtualLight y : lights.lights) {
    sources_.push_back(source(y));
    if (!job.two_sided) continue;
    y.arriving -= 2 * dot(y.arriving, y.normal) * y.normal;
    y.normal = -y.normal;
    y.shading_normal = -y.shading_normal;
    behind_.push_back(source(y));
  }
  if (job.clamping == Clamping::compensate) rays_.emplace(ray_points(job), width);
}

GlobalIllumination::Source GlobalIllumination::source(const VirtualLight& y) const {
  const double cosine = dot(y.arriving, y.shading_normal), geometric = dot(y.arriving, y.normal);
  const bool above = cosine > 0 && geometric > 0;
  return {y, lighting_.vertices().bsdfs().at(y.material, y.uv), Frame(y.shading_normal), Frame(y.normal),
          above ? cosine / geometric : 0};
}

FixedPoint GlobalIllumination::number(const Stream& stream, std::uint32_t surface, std::uint32_t pair) const {
  const auto words =
      pcg4d(stream.pixel, stream.index, pair + kPairsOfASurface * surface, job_.direct.seed ^ kSeed);
  return {words[0], words[1]};
}

dvec3 GlobalIllumination::from(const Vertex& x, const Source& y, std::uint64_t& rays) const {
  const dvec3 to = y.light.position - x.at.position;
  const double distance = glm::length(to);
  if (!(distance > 0)) return dvec3(0);
  const dvec3 direction = to / distance;
  const double leaving = -dot(direction, y.light.normal);
  if (leaving < 0 && job_.two_sided) return from_behind(x, y, rays);
  if (!(leaving > 0)) return dvec3(0);
  const dvec3 in = x.frame.to_local(direction);
  const dvec3 received = x.reflect(direction, in);  // f_x (w . n_s), which G holds
  if (received == dvec3(0)) return dvec3(0);
  const bool by_shading = dot(y.light.shading_normal, direction) < 0;
  const Frame& frame = by_shading ? y.shading : y.geometric;
  const double ratio = by_shading ? y.shading_ratio : 1;
  const dvec3 sent =
      y.bsdf.evaluate(frame.to_local(y.light.arriving), frame.to_local(-direction)) * ratio * y.light.flux;
  if (sent == dvec3(0)) return dvec3(0);
  ++rays;
  if (geometry_.tree.occluded({x.at.position, direction}, distance * kWay, {x.ignored})) return dvec3(0);
  const double term = in.z * leaving / std::max(distance * distance, kLeastDistance2);
  return received * sent * (std::min(limit_, term) / in.z);
}

dvec3 GlobalIllumination::from_behind(const Vertex& x, const Source& y, std::uint64_t& rays) const {
  VirtualLight turned = y.light;
  turned.normal = -turned.normal;
  turned.shading_normal = -turned.shading_normal;
  turned.arriving -= 2 * dot(turned.arriving, turned.normal) * turned.normal;
  // It lay off the other side of its surface, which must not hide it, by no more than float needs.
  turned.position += kThickness * geometry_.tree.scale() * turned.normal;
  return from(x, {turned, y.bsdf, Frame(turned.shading_normal), Frame(turned.normal), ratio_of(turned)},
              rays);
}

dvec3 GlobalIllumination::gather(const Vertex& x, std::uint32_t set, std::uint64_t& rays) const {
  dvec3 sum(0);
  for (std::uint32_t k = first_[set]; k < first_[set + 1]; ++k) {
    const VirtualLight& y = sources_[k].light;
    const bool behind = job_.two_sided && dot(y.position - x.at.position, y.normal) > 0;
    sum += from(x, behind ? behind_[k] : sources_[k], rays);
  }
  return sum;
}

dvec3 GlobalIllumination::compensate(const Vertex& x, const glm::dvec2& point, double choice,
                                     std::uint32_t set, const Stream& stream, std::uint32_t surface,
                                     std::uint64_t& rays) const {
  const std::optional<Continuation> next = continue_from(x, point, choice);
  if (!next) return dvec3(0);
  ++rays;
  // Beyond this length the term is below the limit, whichever way the surface there faces.
  const double length = std::sqrt(next->cosine / limit_);
  const std::optional<Seen> met = geometry_.look({x.at.position, next->direction}, {x.ignored}, length);
  if (!met) return dvec3(0);
  const dvec3 between = met->at.position - x.at.position;
  const double term =
      next->cosine * -dot(next->direction, met->at.normal) / std::max(dot(between, between), kLeastDistance2);
  if (!(term > limit_)) return dvec3(0);
  dvec3 weight = next->reflected / next->pdf * (1 - limit_ / term);
  if (surface > 0) {
    const double goes_on = std::min(1.0, luminance(weight));
    if (!(unit_point(number(stream, surface, kGoingOnPair)).x < goes_on)) return dvec3(0);
    weight /= goes_on;
  }
  return weight * reflected(lighting_.vertices().at(*met, -next->direction), set, stream, surface + 1, rays);
}

dvec3 GlobalIllumination::reflected(const Vertex& y, std::uint32_t set, const Stream& stream,
                                    std::uint32_t surface, std::uint64_t& rays) const {
  const auto numbers = [&](std::uint32_t pair) { return unit_point(number(stream, surface, pair)); };
  const Strategy strategy = job_.direct.strategy;
  dvec3 sum = gather(y, set, rays);
  for (int j = 0; j < lighting_.lights().count() && strategy != Strategy::bsdf; ++j)
    sum += lighting_.light_sample(y, j, numbers(kLightPairs + static_cast<std::uint32_t>(j)), strategy, rays);
  if (strategy != Strategy::lights)
    sum += lighting_.bsdf_sample(y, numbers(kBsdfPair), numbers(kComponentPair).x, strategy, rays);
  if (surface < kMostSurfaces)
    sum += compensate(y, numbers(kOnwardsPair), numbers(kComponentPair).y, set, stream, surface, rays);
  return sum;
}

dvec3 GlobalIllumination::indirect(const Vertex& x, std::uint32_t pixel, std::uint32_t set,
                                   std::uint32_t part, std::uint64_t& rays) const {
  dvec3 sum = gather(x, set, rays);
  if (!rays_) return sum;
  dvec3 taken(0);
  for (std::uint32_t c = 0; c < job_.gather; ++c) {
    const glm::dvec2 u = (*rays_)(pixel, part, c, kBsdfPair, SampleDomain::disk);
    taken += compensate(x, u, rays_->choice(pixel, part, c), set, {pixel, part * job_.gather + c}, 0, rays);
  }
  return sum + taken / static_cast<double>(job_.gather);
}

DirectLighting::Estimate GlobalIllumination::pixel(const View& view, int width, int x, int y) const {
  DirectLighting::Estimate estimate;
  if (!job_.only_indirect) estimate = lighting_.pixel(job_.direct, points_, view, width, x, y);
  const auto pixel =
      static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(x);
  const auto side = static_cast<int>(job_.block);
  const auto place = static_cast<std::uint32_t>(x % side + side * (y % side));
  const std::uint32_t sets = job_.sets_a_pixel();
  const bool jittered = job_.direct.position == PixelPosition::jittered;
  const std::uint32_t parts = jittered ? job_.direct.image_samples : sets;
  dvec3 sum(0);
  for (std::uint32_t part = 0; part < parts; ++part) {
    const glm::dvec2 film = points_.film(pixel, x, y, part);
    const Ray ray = view.ray(film.x, film.y);
    const std::optional<Seen> seen = geometry_.look(ray);
    if (!seen) continue;
    const std::uint32_t set = place + job_.block * job_.block * (part % sets);
    sum += indirect(lighting_.vertices().at(*seen, -ray.direction), pixel, set, part, estimate.rays);
  }
  estimate.radiance += sum / static_cast<double>(parts);
  return estimate;
}

}  // namespace capcon::reference
