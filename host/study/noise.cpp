#include "study/noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/coarse.h"

namespace capcon {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
using Kept = std::span<const std::size_t>;  // indices of seeds

/// products[i][j]: mean over values of the errors of images i and j. All that is said of noise and bias
/// follows from it, for any choice of seeds.
using Products = std::vector<std::vector<double>>;

Products products_of(const std::vector<Image>& images, const Image& reference) {
  const std::size_t count = images.size(), values = reference.pixels.size();
  Products products(count, std::vector<double>(count));
  std::vector<double> errors(count);
  for (std::size_t k = 0; k < values; ++k) {
    for (std::size_t i = 0; i < count; ++i)
      errors[i] = static_cast<double>(images[i].pixels[k]) - reference.pixels[k];
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j <= i; ++j) products[i][j] += errors[i] * errors[j];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) products[j][i] = products[i][j] /= static_cast<double>(values);
  }
  return products;
}

/// Means over pixels of what some of the seeds say.
struct Moments {
  double square = 0;      ///< of single errors
  double mean_error = 0;  ///< square of the mean's error
  double variance = 0;    ///< over seeds
};

Moments moments_of(const Products& products, Kept kept) {
  const double n = static_cast<double>(kept.size());
  Moments m;
  for (const std::size_t i : kept) {
    m.square += products[i][i] / n;
    for (const std::size_t j : kept) m.mean_error += products[i][j] / n / n;
  }
  m.variance = kept.size() < 2 ? kUnknown : std::max(0.0, m.square - m.mean_error) * n / (n - 1);
  return m;
}

double mean_of(const std::vector<double>& values, Kept kept) {
  double sum = 0;
  for (const std::size_t i : kept) sum += values[i];
  return sum / static_cast<double>(kept.size());
}

double log_mean(const std::vector<double>& values, Kept kept) {
  double sum = 0;
  for (const std::size_t i : kept) sum += std::log(values[i]);
  return sum / static_cast<double>(kept.size());
}

std::vector<Image> images_of(const StudyResult& result, const RunImages& images, const std::string& sampler,
                             std::uint32_t samples) {
  std::vector<Image> found;
  for (std::uint32_t seed = 1; seed <= result.settings.seeds; ++seed) {
    if (auto image = images.read({sampler, samples, seed})) found.push_back(std::move(*image));
  }
  return found;
}

bool is_mapped(const std::string& sampler) {
  return sampler == "sobol-xor" || sampler == "capcon" || sampler == "capcon-domain";
}

std::uint32_t mapped_count(const std::vector<std::uint32_t>& counts) {
  constexpr std::uint32_t kPreferred = 4;
  return std::find(counts.begin(), counts.end(), kPreferred) != counts.end() ? kPreferred
                                                                             : counts[counts.size() / 2];
}

}  // namespace

const NoiseCell* Noise::cell(const std::string& sampler, std::uint32_t samples) const {
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const NoiseCell& c) {
    return c.sampler == sampler && c.samples == samples;
  });
  return found == cells.end() ? nullptr : &*found;
}

NoiseCell noise_of(const std::vector<Image>& images, const ReferenceImage& reference) {
  const Products products = products_of(images, reference.image);
  std::vector<std::size_t> all(images.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const double seeds = static_cast<double>(all.size());
  NoiseCell cell;
  for (const Image& image : images)
    cell.coarse_mse.push_back(coarse_mse(image, reference.image) - reference.coarse_error);
  const Moments moments = moments_of(products, all);
  cell.mean_error = std::sqrt(moments.mean_error);
  cell.chance = std::sqrt(moments.variance / seeds + reference.error);
  cell.coarse = jackknife(all.size(), [&](Kept kept) {
    return mean_of(cell.coarse_mse, kept) / (moments_of(products, kept).square - reference.error);
  });
  const auto deviation = [&](Kept kept) { return std::sqrt(moments_of(products, kept).variance); };
  const auto bias = [&](Kept kept) {
    const Moments m = moments_of(products, kept);
    return m.mean_error - m.variance / static_cast<double>(kept.size()) - reference.error;
  };
  // Leaving one of two out leaves no variance.
  if (all.size() > 2) {
    cell.deviation = jackknife(all.size(), deviation);
    cell.bias_square = jackknife(all.size(), bias);
  } else {
    cell.deviation = {deviation(all), kUnknown, kUnknown};
    cell.bias_square = {bias(all), kUnknown, kUnknown};
  }
  return cell;
}

NoiseMap noise_map(const std::vector<Image>& images, const Image& reference) {
  NoiseMap map;
  map.deviation = map.mean_error = Image(reference.width, reference.height, 1);
  const int channels = reference.channels;
  const double seeds = static_cast<double>(images.size());
  for (std::size_t pixel = 0; pixel < map.deviation.pixels.size(); ++pixel) {
    double variance = 0, error = 0;
    for (int c = 0; c < channels; ++c) {
      const std::size_t k = pixel * channels + c;
      double mean = 0, square = 0;
      for (const Image& image : images) mean += image.pixels[k] / seeds;
      for (const Image& image : images) square += (image.pixels[k] - mean) * (image.pixels[k] - mean);
      variance += square / std::max(1.0, seeds - 1) / channels;
      error += (mean - reference.pixels[k]) * (mean - reference.pixels[k]) / channels;
    }
    map.deviation.pixels[pixel] = static_cast<float>(std::sqrt(variance));
    map.mean_error.pixels[pixel] = static_cast<float>(std::sqrt(error));
  }
  return map;
}

Interval coarse_ratio(const NoiseCell& a, const NoiseCell& b) {
  const auto positive = [](const std::vector<double>& v) {
    return !v.empty() && std::all_of(v.begin(), v.end(), [](double x) { return x > 0; });
  };
  if (!positive(a.coarse_mse) || !positive(b.coarse_mse) || a.coarse_mse.size() != b.coarse_mse.size())
    return {kUnknown, kUnknown, kUnknown};
  return exp(jackknife(a.coarse_mse.size(), [&](Kept kept) {
    return log_mean(a.coarse_mse, kept) - log_mean(b.coarse_mse, kept);
  }));
}

Noise make_noise(const StudyResult& result, const RunImages& images) {
  const StudySettings& s = result.settings;
  const Image& reference = result.reference.image;
  Noise noise;
  noise.seeds = s.seeds;
  noise.map_samples = mapped_count(s.samples);
  const Image blocks = block_means(reference);
  noise.coarse_by_chance =
      static_cast<double>(blocks.pixels.size()) / static_cast<double>(reference.pixels.size());
  for (const std::uint32_t samples : s.samples) {
    for (const std::string& sampler : s.samplers) {
      const std::vector<Image> found = images_of(result, images, sampler, samples);
      if (found.empty()) continue;
      NoiseCell cell = noise_of(found, result.reference);
      cell.sampler = sampler;
      cell.samples = samples;
      noise.cells.push_back(std::move(cell));
      if (samples != noise.map_samples || !is_mapped(sampler) || found.size() < 2) continue;
      noise.maps.push_back(noise_map(found, reference));
      noise.maps.back().sampler = sampler;
    }
  }
  return noise;
}

}  // namespace capcon
