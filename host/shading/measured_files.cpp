#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/file.h"
#include "scene/number_text.h"
#include "scene/text_lines.h"
#include "shading/measured_brdf.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr std::size_t kMostSamples = 100'000;
constexpr std::size_t kMostWavelengths = 4096;
constexpr double kHalfPi = 1.57079632679489661923;

/// The numbers of a text, one by one, with the line they stand in.
class Numbers {
 public:
  Numbers(std::string_view bytes, const std::string& name) : lines_(bytes), name_(name) {}

  /// False at the end of the text.
  bool next(double& value) {
    while (position_ == words_.size()) {
      if (!lines_.next()) return false;
      words_ = split_words(lines_.line().substr(0, lines_.line().find('#')));
      position_ = 0;
    }
    const std::string_view word = words_[position_++];
    if (parse_number(word, value) == NumberText::ok) return true;
    fail(fmt::format("a BRDF table holds numbers only, not \"{:.20}\"", word));
  }
  double want(const char* what) {
    double value = 0;
    if (!next(value)) fail(fmt::format("the table ends before {}", what));
    return value;
  }
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError({name_, lines_.number(), 0}, sentence);
  }

 private:
  TextLines lines_;
  std::string name_;
  std::vector<std::string_view> words_;
  std::size_t position_ = 0;
};

std::vector<double> read_wavelengths(Numbers& numbers) {
  const double count = numbers.want("the number of wavelengths");
  if (!(count >= 1 && count <= kMostWavelengths && count == std::floor(count)))
    numbers.fail(fmt::format("the number of wavelengths must be 1 to {}, not {}", kMostWavelengths, count));
  std::vector<double> wavelengths;
  while (wavelengths.size() < count) {
    const double wavelength = numbers.want("the last wavelength");
    if (!wavelengths.empty() && !(wavelength > wavelengths.back()))
      numbers.fail(fmt::format("wavelengths must rise; {} follows {}", wavelength, wavelengths.back()));
    wavelengths.push_back(wavelength);
  }
  return wavelengths;
}

/// Size of the planes that the first 12 bytes promise, 0 when they are no table's.
std::size_t merl_cells(std::string_view bytes, std::array<int, 3>& size) {
  static_assert(std::endian::native == std::endian::little);
  if (bytes.size() < 12) return 0;
  std::memcpy(size.data(), bytes.data(), 12);
  std::size_t cells = 1;
  for (const int length : size) {
    if (length < 1 || length > 4096) return 0;
    cells *= static_cast<std::size_t>(length);
  }
  return cells;
}

}  // namespace

CornellBrdf parse_cornell_brdf(std::string_view bytes, const std::string& name) {
  Numbers numbers(bytes, name);
  const std::vector<double> wavelengths = read_wavelengths(numbers);
  const std::vector<glm::dvec3> weights = reflectance_weights(wavelengths);
  CornellBrdf brdf;
  for (double theta = 0; numbers.next(theta);) {
    if (brdf.samples.size() == kMostSamples)
      numbers.fail(fmt::format("a table of more than {} rows is not read", kMostSamples));
    BrdfSample sample{theta, numbers.want("phi_i"), numbers.want("theta_s"), numbers.want("phi_s"), {}};
    for (const double angle : {sample.theta_in, sample.theta_out}) {
      if (!(angle >= 0 && angle <= kHalfPi))
        numbers.fail(fmt::format("a theta must lie between 0 and pi/2, not at {}", angle));
    }
    if (std::abs(sample.phi_in) > 100 || std::abs(sample.phi_out) > 100)
      numbers.fail("a phi is given in radians and lies near 0 to 2 pi");
    for (const glm::dvec3& weight : weights) {
      const double value = numbers.want("the last value of its row");
      if (value > 1e6) numbers.fail(fmt::format("{} is no value of a BRDF", value));
      if (value < 0) ++brdf.negatives;
      sample.value += std::max(value, 0.0) * weight;
    }
    for (int c = 0; c < 3; ++c) sample.value[c] = std::max(sample.value[c], 0.0);
    brdf.samples.push_back(sample);
  }
  if (brdf.samples.empty()) numbers.fail("the table has no rows");
  return brdf;
}

MerlBrdf parse_merl_brdf(std::string_view bytes, const std::string& name) {
  MerlBrdf brdf;
  const std::size_t cells = merl_cells(bytes, brdf.size);
  if (cells == 0)
    throw InputError(name + ": this is no MERL table: it does not start with three sizes from 1 to 4096");
  if (bytes.size() - 12 != cells * 24) {
    throw InputError(fmt::format("{}: a MERL table of {} x {} x {} has {} bytes, this file has {}", name,
                                 brdf.size[0], brdf.size[1], brdf.size[2], cells * 24 + 12, bytes.size()));
  }
  constexpr std::array<double, 3> kScale = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
  brdf.values.resize(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    bool is_measured = true;
    for (std::size_t c = 0; c < 3; ++c) {
      double value = 0;
      std::memcpy(&value, bytes.data() + 12 + (c * cells + i) * 8, 8);
      value *= kScale[c];
      is_measured = is_measured && value >= 0 && value <= 1e6;
      brdf.values[i][static_cast<int>(c)] = static_cast<float>(value);
    }
    if (!is_measured) brdf.values[i] = glm::vec3(-1);
  }
  return brdf;
}

MeasuredBrdf read_measured_brdf(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  std::array<int, 3> size{};
  const std::size_t cells = merl_cells(bytes, size);
  const std::string extension = path.extension().string();
  const bool is_merl =
      extension == ".binary" || extension == ".merl" || (cells > 0 && bytes.size() == 12 + 24 * cells);
  MeasuredBrdf brdf = is_merl ? resample(parse_merl_brdf(bytes, path.string()))
                              : resample(parse_cornell_brdf(bytes, path.string()));
  fit_sampling(brdf);
  double most = 0;
  for (const double cosine : {0.97, 0.87, 0.71, 0.5, 0.26, 0.17}) {
    const glm::dvec3 albedo = directional_albedo(brdf, cosine);
    most = std::max({most, albedo.x, albedo.y, albedo.z});
  }
  if (most > 1.01)  // the quadrature is good to 1 %
    brdf.remarks.push_back(fmt::format("it reflects up to {:.2f} times the light that arrives", most));
  return brdf;
}

}  // namespace capcon
