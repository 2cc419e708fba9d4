#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace capcon {

/// What a study estimates.
enum class Integral : std::uint8_t {
  ambient_occlusion,  ///< occlusion rays a pixel
  direct,             ///< direct lighting, one image sample a pixel, points of the integrator
  splitting,  ///< direct lighting, as many points a pixel, split into image samples and points of each
  global_illumination  ///< instant global illumination, indirect light alone: sets of light paths
                       ///< (docs/igi.md)
};

/// How a study's reports speak of it.
struct IntegralWords {
  std::string_view slug;     ///< name of the verb, and in files
  std::string_view title;    ///< "Ambient occlusion"
  std::string_view counts;   ///< what the counts of `StudySettings::samples` count
  std::string_view one;      ///< a single one of them: "sample"
  std::string_view many;     ///< "samples"
  std::string_view formula;  ///< HTML
  std::string_view picture;  ///< what the picture shows
};
const IntegralWords& words_of(Integral integral);

/// A sampler in a study of splitting or of global illumination: "capcon" makes the sets of a pixel, or of
/// light paths, the parts of one, "capcon-naive" makes them sets of their own, "capcon-naive2" with twice as
/// many points.
struct Variant {
  std::string sampler;
  bool partition = true;
  std::uint32_t factor = 1;  ///< of the integrator's points, or of light paths
};
Variant parse_variant(const std::string& name);
/// Whether a study's samplers may be variants.
inline bool has_variants(Integral integral) {
  return integral == Integral::splitting || integral == Integral::global_illumination;
}
/// Whether a study keeps the images of its runs, to tell noise from structure.
inline bool keeps_images(Integral integral) {
  return integral == Integral::global_illumination;
}

}  // namespace capcon
