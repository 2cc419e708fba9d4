#include "study/close_ups.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "image/compare.h"
#include "image/flip.h"

namespace capcon {
namespace {

/// How large and how well the picture is rendered.
struct Extent {
  double pixels = 144e3;
  std::uint32_t samples = 128;  // of the picture itself
  double region_part = 0.22;    // of the picture's width
};

/// Blotches are as large as the room is; and every set is hundreds of rays a pixel.
Extent extent_of(Integral integral) {
  return integral == Integral::global_illumination ? Extent{8e3, 32, 0.5} : Extent{};
}

/// 4 and 16 samples; 4 sets; of splits the one in the middle.
std::vector<std::uint32_t> close_up_counts(const StudySettings& settings) {
  if (settings.integral == Integral::global_illumination) return {4};
  if (settings.integral != Integral::splitting) return {4, 16};
  return {settings.samples[settings.samples.size() / 2]};
}

/// Smaller where there are so many views that a page with all of them would be large.
int region_width_of(const Extent& extent, int width, std::size_t planes) {
  constexpr double kMostValues = 4e5;  // of all views: 1.7 MB of a page
  const double wanted = std::round(width * extent.region_part);
  return static_cast<int>(std::min(wanted, std::sqrt(kMostValues / (0.75 * static_cast<double>(planes)))));
}

float common_exposure(const std::vector<CloseUp>& views) {
  std::vector<float> all;
  for (const CloseUp& view : views)
    all.insert(all.end(), view.difference.pixels.begin(), view.difference.pixels.end());
  if (all.empty()) return 1;
  const auto place = all.begin() + static_cast<std::ptrdiff_t>(all.size() - 1 - all.size() / 100);
  std::nth_element(all.begin(), place, all.end());
  if (*place <= 0) return 1;
  return std::max(0.1f, std::round(10 / *place) / 10);
}

}  // namespace

Image absolute_difference(const Image& a, const Image& b) {
  Image result = a;
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = std::abs(a.pixels[i] - b.pixels[i]);
  return result;
}

Image crop(const Image& image, const Region& region) {
  Image result(region.width, region.height, image.channels);
  for (int y = 0; y < region.height; ++y) {
    for (int x = 0; x < region.width; ++x) {
      for (int c = 0; c < image.channels; ++c) result.at(x, y, c) = image.at(region.x + x, region.y + y, c);
    }
  }
  return result;
}

Region worst_region(const Image& errors, int width, int height) {
  Region best{0, 0, std::min(width, errors.width), std::min(height, errors.height)};
  double most = -1;
  constexpr int kStep = 4;
  for (int y = 0; y + best.height <= errors.height; y += kStep) {
    for (int x = 0; x + best.width <= errors.width; x += kStep) {
      double sum = 0;
      for (int v = 0; v < best.height; ++v) {
        for (int u = 0; u < best.width; ++u) sum += errors.at(x + u, y + v, 0);
      }
      if (sum > most) {
        most = sum;
        best.x = x;
        best.y = y;
      }
    }
  }
  return best;
}

CloseUps make_close_ups(const StudySettings& settings, const MakeStudyDevice& make_device,
                        const RunnerOptions& options) {
  const Extent extent = extent_of(settings.integral);
  const double scale = std::max(1.0, std::sqrt(extent.pixels / settings.width / settings.height));
  const int width = static_cast<int>(std::lround(settings.width * scale));
  const int height = static_cast<int>(std::lround(settings.height * scale));
  const StudyDevice device = make_device(width, height);

  CloseUps result;
  result.samples = close_up_counts(settings);
  result.picture_samples = extent.samples;
  double done = 0;
  Progress progress("close-ups", extent.samples + 20.0 * static_cast<double>(settings.samplers.size()),
                    options.quiet);
  const auto render = [&](const Job& job, std::uint32_t samples) {
    Image image = device.render(job).image;
    progress.update(done += samples);
    return image;
  };
  StudySettings picture = settings;
  picture.reference_samples = extent.samples;
  result.picture = render(make_reference_job(picture, 0), extent.samples);
  Image errors(width, height, 1);
  std::vector<Image> images;
  for (const std::uint32_t samples : result.samples) {
    for (const std::string& sampler : settings.samplers) {
      images.push_back(render(make_job(settings, {sampler, samples, result.seed}), samples));
      result.views.push_back({sampler, samples, {}, {}, 0, 0});
      if (samples != result.samples.back()) continue;
      const int channels = result.picture.channels;
      for (std::size_t i = 0; i < result.picture.pixels.size(); ++i) {
        const float d = images.back().pixels[i] - result.picture.pixels[i];
        errors.pixels[i / channels] += d * d;
      }
    }
  }
  const int region_width = region_width_of(extent, width, result.views.size() * result.picture.channels);
  result.region = worst_region(errors, region_width, region_width * 3 / 4);
  result.reference = crop(result.picture, result.region);
  for (std::size_t i = 0; i < images.size(); ++i) {
    CloseUp& view = result.views[i];
    view.crop = crop(images[i], result.region);
    view.difference = absolute_difference(view.crop, result.reference);
    view.flip = flip(view.crop, result.reference);
    view.mse = compare(view.crop, result.reference).mse;
  }
  result.exposure = common_exposure(result.views);
  return result;
}

}  // namespace capcon
