#include "reference/direct_lighting.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/pixel_filter.h"
#include "reference/unit_point.h"
#include "sampling/choice.h"

namespace capcon::reference {
namespace {

using glm::dot;
using glm::dvec3;

// Dimension pairs of the samplers.
constexpr std::uint32_t kBsdfPair = 0;
constexpr std::uint32_t kPixelPair = 1;
constexpr std::uint32_t kLightPairs = 3;
constexpr std::uint32_t kPairsOfAPart = 65536;

/// How much of the way to a light is looked at.
constexpr double kWay = 1 - 0x1p-17;

/// m(p, q) of what was sampled with density p and might have been with q.
double mis_weight(Strategy strategy, double p, double q) {
  const double ratio = q / p;
  return 1 / (1 + (strategy == Strategy::balance ? ratio : ratio * ratio));
}

bool combines(Strategy strategy) {
  return strategy == Strategy::power || strategy == Strategy::balance;
}

}  // namespace

DirectPoints::DirectPoints(const DirectLightingJob& job, int width) : job_(job) {
  integrand_ = job.partition ? make_sampler(job.sampler, job.samples(), job.seed, job.image_samples, width)
                             : make_sampler(job.sampler, job.integrator_samples, job.seed, 1, width);
  if (job.position == PixelPosition::jittered)
    image_ = make_sampler(job.sampler, job.image_samples, job.seed, 1, width);
}

glm::dvec2 DirectPoints::film(std::uint32_t pixel, int x, int y, std::uint32_t p) const {
  if (!image_) return {x + 0.5, y + 0.5};
  const glm::dvec2 u = unit_point(image_->sample(pixel, p, kPixelPair));
  if (job_.filter == PixelFilter::box) return {x + u.x, y + u.y};
  return {x + 0.5 + gaussian_quantile(u.x), y + 0.5 + gaussian_quantile(u.y)};
}

glm::dvec2 DirectPoints::operator()(std::uint32_t pixel, std::uint32_t p, std::uint32_t i, std::uint32_t pair,
                                    SampleDomain domain) const {
  if (job_.partition)
    return unit_point(integrand_->sample(pixel, p * job_.integrator_samples + i, pair, domain));
  return unit_point(integrand_->sample(pixel, i, pair + kPairsOfAPart * p, domain));
}

double DirectPoints::choice(std::uint32_t pixel, std::uint32_t p, std::uint32_t i) const {
  Split split;
  split.parts = job_.image_samples;
  split.points = job_.integrator_samples;
  return unit_point({component_choice(job_.seed, pixel, p, i, split, !job_.partition), 0}).x;
}

std::vector<std::string> DirectLighting::warnings() const {
  std::vector<std::string> all = vertices_.bsdfs().warnings();
  const auto& lights = lights_.lights().warnings;
  all.insert(all.end(), lights.begin(), lights.end());
  return all;
}

dvec3 DirectLighting::emitted(const Seen& seen, const Ray& ray) const {
  const int light = lights_.of_primitive(seen.primitive);
  return light < 0 ? dvec3(0) : lights_.meet(light, seen.primitive, ray, seen.t).radiance;
}

dvec3 DirectLighting::light_sample(const Vertex& vertex, int light, const glm::dvec2& point,
                                   Strategy strategy, std::uint64_t& rays) const {
  const SurfacePoint& at = vertex.at;
  const auto sample = lights_.sample(light, at.position, at.normal, point);
  if (!sample) return dvec3(0);
  const dvec3 in = vertex.frame.to_local(sample->direction);
  const dvec3 reflected = vertex.reflect(sample->direction, in);
  if (reflected == dvec3(0)) return dvec3(0);
  ++rays;
  const Ignored ignored{vertex.ignored, sample->first, sample->count};
  if (geometry_.tree.occluded({at.position, sample->direction}, sample->distance * kWay, ignored))
    return dvec3(0);
  double weight = 1;
  if (combines(strategy) && lights_.findable(light))
    weight = mis_weight(strategy, sample->pdf, vertex.bsdf.pdf(in, vertex.out));
  return reflected * sample->radiance * (weight / sample->pdf);
}

dvec3 DirectLighting::bsdf_sample(const Vertex& vertex, const glm::dvec2& point, double choice,
                                  Strategy strategy, std::uint64_t& rays) const {
  const SurfacePoint& at = vertex.at;
  const std::optional<Continuation> next = continue_from(vertex, point, choice);
  if (!next) return dvec3(0);
  const auto weight = [&](double light_pdf) {
    return combines(strategy) ? mis_weight(strategy, next->pdf, light_pdf) : 1;
  };
  ++rays;
  const Ray ray(at.position, next->direction);
  dvec3 light(0);
  if (const auto hit = geometry_.tree.closest(ray, {vertex.ignored})) {
    const int index = lights_.of_primitive(hit->primitive);
    if (index < 0) return dvec3(0);
    const LightMet met = lights_.meet(index, hit->primitive, ray, hit->t);
    if (met.radiance != dvec3(0)) light = met.radiance * weight(met.pdf);
  } else {
    for (int j = 0; j < lights_.count(); ++j) {
      if (lights_.lights().values[j].kind != LightKind::environment) continue;
      const LightMet met = lights_.environment(j, at.normal, next->direction);
      light += met.radiance * weight(met.pdf);
    }
  }
  return next->reflected * light / next->pdf;
}

DirectLighting::Estimate DirectLighting::pixel(const DirectLightingJob& job, const DirectPoints& points,
                                               const View& view, int width, int x, int y) const {
  const auto pixel =
      static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(x);
  Estimate estimate;
  dvec3 emission(0), reflection(0);
  for (std::uint32_t p = 0; p < job.image_samples; ++p) {
    const glm::dvec2 place = points.film(pixel, x, y, p);
    const Ray ray = view.ray(place.x, place.y);
    const std::optional<Seen> seen = geometry_.look(ray);
    if (!seen) {
      emission += lights_.background(ray.direction);
      continue;
    }
    emission += emitted(*seen, ray);
    const Vertex vertex = vertices_.at(*seen, -ray.direction);
    for (int j = 0; j < lights_.count() && job.strategy != Strategy::bsdf; ++j) {
      const SampleDomain domain = lights_.domain(j, seen->at.position);
      for (std::uint32_t i = 0; i < job.integrator_samples; ++i) {
        const glm::dvec2 u = points(pixel, p, i, kLightPairs + static_cast<std::uint32_t>(j), domain);
        reflection += light_sample(vertex, j, u, job.strategy, estimate.rays);
      }
    }
    for (std::uint32_t i = 0; i < job.integrator_samples && job.strategy != Strategy::lights; ++i) {
      const glm::dvec2 u = points(pixel, p, i, kBsdfPair, SampleDomain::disk);
      const double choice = points.choice(pixel, p, i);
      reflection += bsdf_sample(vertex, u, choice, job.strategy, estimate.rays);
    }
  }
  estimate.radiance = (emission + reflection / static_cast<double>(job.integrator_samples)) /
                      static_cast<double>(job.image_samples);
  return estimate;
}

}  // namespace capcon::reference
