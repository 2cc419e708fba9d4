#include "sampling/sampler.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "base/error.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/choice.h"
#include "sampling/point_file.h"
#include "sampling/samplers.h"

namespace capcon {

namespace {
using Maker = std::unique_ptr<Sampler> (*)(std::uint32_t, std::uint32_t, std::uint32_t);

// The one place to name a new sampler; its id is in shaders/layout.h.
const std::vector<std::pair<std::string, Maker>>& makers() {
  static const std::vector<std::pair<std::string, Maker>> all = {
      {"random", make_random_sampler},
      {"jittered", make_jittered_sampler},
      {"sobol-xor", make_sobol_xor_sampler},
      {"sobol-owen", make_sobol_owen_sampler},
      {"ccvt", make_ccvt_sampler},
      {"capcon", make_capcon_sampler},
      {"capcon-domain", make_capcon_domain_sampler},
      {"capcon-ranked", make_capcon_ranked_sampler},
      {"fpo", make_fpo_sampler},
      {"halton", make_halton_sampler},
      {"lattice", make_lattice_sampler},
      {"pmj02", make_pmj02_sampler}};
  return all;
}

// For some numbers of points only: not among sampler_names().
constexpr std::string_view kBounded = "capcon-bounded", kScreen = "capcon-screen";
// Knows a pixel's neighbours.
constexpr std::string_view kZ = "sobol-z";
}  // namespace

std::uint32_t coprime_stride(std::uint32_t count) {
  std::uint32_t stride = std::max(1u, static_cast<std::uint32_t>(std::lround(count * 0.61803398875)));
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

const std::vector<std::string>& sampler_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, maker] : makers()) all.push_back(name);
    all.emplace_back(kZ);
    return all;
  }();
  return names;
}

const std::vector<std::string>& default_study_samplers() {
  static const std::vector<std::string> names = {"random", "jittered", "sobol-xor",    "sobol-owen",
                                                 "ccvt",   "capcon",   "capcon-domain"};
  return names;
}

Sampler::Sampler(std::string name, std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
    : name_(std::move(name)),
      split_{parts, count / parts, coprime_stride(parts), coprime_stride(count / parts)},
      seed_(seed) {}

std::uint32_t Sampler::shuffled(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const {
  const std::uint32_t key = set_words(seed_, pixel, dimension)[2];
  if (split_.parts > 1 && split_.points > 1) return shuffle_split(index, split_, key);
  return place_in_order(index, count(), split_.parts > 1 ? split_.part_stride : split_.point_stride,
                        dimension, key);
}

std::uint32_t Sampler::place_in_order(std::uint32_t index, std::uint32_t count, std::uint32_t stride,
                                      std::uint32_t, std::uint32_t key) const {
  return is_stored_by_place() ? permute(index, count, key) : shuffle_index(index, count, stride, key);
}

std::unique_ptr<Sampler> make_sampler(std::string_view name, std::uint32_t count, std::uint32_t seed,
                                      std::uint32_t parts, int width) {
  if (count == 0) throw InputError("the number of samples must be at least 1");
  if (parts == 0 || count % parts != 0)
    throw InputError(fmt::format("{} points cannot be cut into {} equal parts", count, parts));
  if (is_point_file(name)) return make_point_file_sampler(name, count, seed, parts);
  for (const auto& [known, maker] : makers()) {
    if (known == name) return maker(count, seed, parts);
  }
  const auto across = static_cast<std::uint32_t>(width);
  if (name == kZ) return make_sobol_z_sampler(count, seed, parts, across);
  if (name == kScreen) return make_capcon_screen_sampler(count, seed, parts, across);
  if (name == kBounded) return make_capcon_bounded_sampler(count, seed, parts);
  throw InputError(
      fmt::format("there is no sampler \"{}\"; choose one of: {}; {} for at most 256 points; {} for 64, 144, "
                  "256, ...; or file:PATH for your "
                  "own points",
                  name, fmt::join(sampler_names(), " "), kScreen, kBounded));
}

}  // namespace capcon
