#include "study/reference_image.h"

#include <fmt/format.h>

#include <cassert>
#include <charconv>

#include "base/error.h"
#include "study/coarse.h"

namespace capcon {
namespace {

/// Expected coarse_mse() of the groups' mean.
double coarse_error_of(const std::vector<Image>& groups, const Image& centre) {
  double squares = 0;
  for (const Image& group : groups) squares += coarse_mse(group, centre);
  const double count = static_cast<double>(groups.size());
  return squares / (count - 1) / count;
}

/// A number kept as text, with all its digits. out_of_range or bad_variant_access where it is not there.
double number_from(const Attributes& attributes, const char* name) {
  const auto& text = std::get<std::string>(attributes.at(name));
  double value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc())
    throw std::out_of_range(name);
  return value;
}

}  // namespace

ReferenceImage combine_groups(const std::vector<Image>& groups) {
  assert(groups.size() >= 2);
  const std::size_t count = groups.size();
  ReferenceImage result{Image(groups[0].width, groups[0].height, groups[0].channels), 0, 0};
  double variance = 0;
  for (std::size_t i = 0; i < result.image.pixels.size(); ++i) {
    double sum = 0;
    for (const Image& group : groups) sum += group.pixels[i];
    const double centre = sum / static_cast<double>(count);
    double square = 0;
    for (const Image& group : groups) square += (group.pixels[i] - centre) * (group.pixels[i] - centre);
    variance += square / static_cast<double>(count - 1);
    result.image.pixels[i] = static_cast<float>(centre);
  }
  result.error = variance / static_cast<double>(result.image.pixels.size()) / static_cast<double>(count);
  result.coarse_error = coarse_error_of(groups, result.image);
  return result;
}

void write_reference(const std::filesystem::path& path, const ReferenceImage& reference,
                     const StudySettings& settings, const std::string& hash) {
  // As text the error keeps all its digits.
  write_exr(path, reference.image,
            {{"samplesPerPixel", static_cast<int>(settings.reference_samples * settings.reference_groups)},
             {"MSE", static_cast<float>(reference.error)},
             {"referenceError", fmt::format("{}", reference.error)},
             {"referenceCoarseError", fmt::format("{}", reference.coarse_error)},
             {"sampler", std::string(kReferenceSampler)},
             {"settingsHash", hash}});
}

std::optional<ReferenceImage> read_reference(const std::filesystem::path& path, const std::string& hash) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  try {
    Attributes attributes;
    ReferenceImage result{read_exr(path, &attributes), 0, 0};
    if (std::get<std::string>(attributes.at("settingsHash")) != hash) return std::nullopt;
    result.error = number_from(attributes, "referenceError");
    result.coarse_error = number_from(attributes, "referenceCoarseError");
    return result;
  } catch (const InputError&) {
    return std::nullopt;  // not an image that this study wrote: it is made again
  } catch (const std::out_of_range&) {
    return std::nullopt;
  } catch (const std::bad_variant_access&) {
    return std::nullopt;
  }
}

}  // namespace capcon
