#include "sampling/sampler.h"

#include "base/data_folder.h"
#include "base/file.h"
#include "capcon/sampler.h"

namespace capcon::sampling {

struct Sampler::State {
  std::unique_ptr<capcon::Sampler> sampler;
};

Sampler::Sampler(std::string_view name, std::uint32_t count, std::uint32_t seed, std::uint32_t parts,
                 const std::string& data) {
  use_data_folder(data);
  state_ = std::make_unique<State>(State{make_sampler(name, count, seed, parts)});
}

Sampler::Sampler(Sampler&&) noexcept = default;
Sampler& Sampler::operator=(Sampler&&) noexcept = default;
Sampler::~Sampler() = default;

Point Sampler::sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                      Domain domain) const {
  const auto p =
      to_double(state_->sampler->sample(pixel, index, dimension, static_cast<capcon::SampleDomain>(domain)));
  return {p.x, p.y};
}

std::vector<Point> Sampler::set(std::uint32_t pixel, std::uint32_t dimension, Domain domain) const {
  std::vector<Point> points;
  points.reserve(count());
  for (std::uint32_t i = 0; i < count(); ++i) points.push_back(sample(pixel, i, dimension, domain));
  return points;
}

std::uint32_t Sampler::count() const {
  return state_->sampler->count();
}

std::uint32_t Sampler::parts() const {
  return state_->sampler->split().parts;
}

std::vector<std::string> sampler_names() {
  return capcon::sampler_names();
}

std::string version() {
  return std::string(capcon::version());
}

}  // namespace capcon::sampling
