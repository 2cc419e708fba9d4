#include "integrate/estimator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <mutex>

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "points/generators.h"
#include "sampling/point_file.h"

namespace capcon::integrate {
namespace {

enum Stream : std::uint64_t { kSets = 1000, kBases, kShifts };

constexpr std::uint32_t kCapacity =
    256;  // that of the renderer's untiled points; more changes errors by less than 3 %

bool has_own_randomness(std::string_view method) {
  return method == "random" || method == "jittered" || method == "sobol-xor" || method == "sobol-owen";
}

class FreshSource final : public PointSource {
 public:
  FreshSource(std::string method, std::uint32_t n, std::uint64_t seed)
      : method_(std::move(method)), n_(n), seed_(seed) {}
  Points set(std::uint64_t trial) const override {
    GeneratorOptions options;
    options.n = n_;
    options.seed = mix64(seed_, kSets, trial);
    return generate(method_, options);
  }

 private:
  std::string method_;
  std::uint32_t n_;
  std::uint64_t seed_;
};

class ShiftedSource final : public PointSource {
 public:
  ShiftedSource(const std::string& method, std::uint32_t n, std::uint64_t seed) : seed_(seed) {
    const double start = cpu_seconds();
    bases_.resize(base_sets(n));
    parallel_for(bases_.size(), [&](std::size_t b) {
      GeneratorOptions options;
      options.n = n;
      options.seed = mix64(seed, kBases, b);
      options.capacity = kCapacity;
      bases_[b] = generate(method, options);
    });
    preparation_seconds = (cpu_seconds() - start) / static_cast<double>(bases_.size());
    cells_.resize(bases_.size());
  }
  Points set(std::uint64_t trial) const override {
    Points points = bases_[trial % bases_.size()];
    const glm::dvec2 shift(uniform64(seed_, kShifts, 2 * trial), uniform64(seed_, kShifts, 2 * trial + 1));
    for (glm::dvec2& p : points) {
      p += shift;
      for (int axis = 0; axis < 2; ++axis) {
        if (p[axis] >= 1) p[axis] -= 1;
      }
    }
    return points;
  }
  TorusCells cells(const Points&, std::uint64_t trial) const override {
    const std::size_t b = trial % bases_.size();
    std::call_once(once_[b], [&] { cells_[b] = torus_cells(bases_[b]); });
    return cells_[b];
  }

 private:
  std::uint64_t seed_;
  std::vector<Points> bases_;
  mutable std::vector<TorusCells> cells_;  ///< made when first asked for
  mutable std::array<std::once_flag, 8> once_;
};

class SamplerSource final : public PointSource {
 public:
  SamplerSource(const std::string& name, std::uint32_t n, std::uint64_t seed) {
    const double start = cpu_seconds();
    sampler_ = make_sampler(name, n, static_cast<std::uint32_t>(mix64(seed, kSets, 0)));
    preparation_seconds = cpu_seconds() - start;
  }
  Points set(std::uint64_t trial) const override {
    Points points(sampler_->count());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      points[i] = to_double(sampler_->sample(static_cast<std::uint32_t>(trial), i, 0, SampleDomain::disk));
    }
    return points;
  }

 private:
  std::unique_ptr<Sampler> sampler_;
};

}  // namespace

const std::vector<Estimator>& estimators() {
  static const std::vector<Estimator> all = [] {
    std::vector<Estimator> list = {{"random", "random", Weights::equal},
                                   {"importance", "random", Weights::importance},
                                   {"random-areas", "random", Weights::areas}};
    for (const std::string& method : generator_names()) {
      if (method == "random") continue;
      list.push_back({method, method, Weights::equal});
      if (method == "ccvt" || method == "fpo" || method == "lloyd")
        list.push_back({method + "-areas", method, Weights::areas});
    }
    for (const char* sampler : {"capcon", "pmj02"}) list.push_back({sampler, sampler, Weights::equal});
    return list;
  }();
  return all;
}

Estimator find_estimator(std::string_view name, const std::map<std::string, std::string>& point_files) {
  const auto file = point_files.find(std::string(name));
  if (file != point_files.end()) return {file->first, file->second, Weights::equal};
  std::vector<std::string> names;
  for (const Estimator& estimator : estimators()) {
    if (estimator.name == name) return estimator;
    names.push_back(estimator.name);
  }
  throw InputError(
      fmt::format("there is no estimator \"{}\"; choose of: {}, or file:PATH", name, fmt::join(names, " ")));
}

std::unique_ptr<PointSource> make_source(const std::string& method, std::uint32_t n, std::uint64_t seed) {
  if (method == "capcon" || method == "pmj02" || is_point_file(method))
    return std::make_unique<SamplerSource>(method, n, seed);
  if (has_own_randomness(method)) return std::make_unique<FreshSource>(method, n, seed);
  return std::make_unique<ShiftedSource>(method, n, seed);
}

std::uint32_t base_sets(std::uint32_t n) {
  return std::clamp(2048 / n, 2u, 8u);
}

std::string randomisation_of(const std::string& method) {
  if (is_point_file(method)) {
    using enum PointFile::Randomisation;
    const PointFile::Randomisation how = parse_point_file(method).randomisation;
    if (how == none) return "another of the file's sets, as it is";
    return how == shift ? "one of the file's sets, a random shift on the torus"
                        : "one of the file's sets, another digit scrambling";
  }
  if (method == "capcon") return "another stochastic tiling and a random shift on the torus";
  if (method == "pmj02") return "another of 64 sequences or fewer, and another digit scrambling";
  if (method == "sobol-xor") return "another digit scrambling";
  if (method == "sobol-owen") return "another Owen scrambling";
  if (has_own_randomness(method)) return "new points";
  return "a random shift on the torus";
}

double cpu_seconds() {
  std::timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace capcon::integrate
