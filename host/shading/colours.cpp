#include "shading/colours.h"

#include <fmt/format.h>

#include <filesystem>
#include <glm/common.hpp>

#include "base/file.h"
#include "scene/number_text.h"
#include "scene/text_lines.h"
#include "shading/metals.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr double kLargest = 1e30;  // so that products of a few stay finite

/// Pairs of wavelength and value.
Spectrum pairs(const std::vector<double>& numbers, const SourcePlace& place, const std::string& what) {
  if (numbers.empty() || numbers.size() % 2 != 0)
    throw InputError(place, what + " must hold pairs of a wavelength and a value");
  Spectrum spectrum;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (i > 0 && !(numbers[i] > numbers[i - 2]))
      throw InputError(place, fmt::format("the wavelengths of {} must rise; {} follows {}", what, numbers[i],
                                          numbers[i - 2]));
    spectrum.wavelengths.push_back(numbers[i]);
    spectrum.values.push_back(numbers[i + 1]);
  }
  return spectrum;
}

/// A file of wavelength-value pairs, "#" before comments.
Spectrum spectrum_file(const std::filesystem::path& path) {
  std::vector<double> numbers;
  const std::string bytes = read_file(path);
  TextLines lines(bytes);
  while (lines.next()) {
    const std::string_view line = lines.line().substr(0, lines.line().find('#'));
    for (const std::string_view word : split_words(line)) {
      double value = 0;
      if (parse_number(word, value) != NumberText::ok)
        throw InputError({path.string(), lines.number(), 0}, "a spectrum file holds numbers only");
      numbers.push_back(value);
    }
  }
  return pairs(numbers, {path.string()}, "this spectrum");
}

glm::dvec3 of_spectrum(const Spectrum& spectrum, ColourUse use) {
  return use == ColourUse::emission ? rgb_of_emission(spectrum) : rgb_of_reflectance(spectrum);
}

glm::dvec3 of_name(const Parameters::Entry& entry, const std::string& what, ColourUse use) {
  const std::string& name = std::get<std::vector<std::string>>(entry.value).front();
  if (const auto metal = named_metal_spectrum(name)) return *metal;
  if (const auto glass = named_glass_index(name)) return glm::dvec3(*glass);
  if (const auto illuminant = rgb_of_illuminant(name)) return *illuminant;
  const std::filesystem::path file = std::filesystem::path(entry.place.file).parent_path() / name;
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error)) return of_spectrum(spectrum_file(file), use);
  throw InputError(entry.place,
                   fmt::format("{} names the spectrum \"{}\", which is neither known nor a file; write it as "
                               "\"rgb\" or as wavelength-value pairs",
                               what, name));
}

glm::dvec3 of_blackbody(const std::vector<double>& numbers, const SourcePlace& place) {
  const bool fits = numbers.size() == 1 || numbers.size() == 2;
  if (!fits || !(numbers[0] >= 100 && numbers[0] <= 1e6))
    throw InputError(place, "a blackbody is one temperature from 100 to 1e6 kelvin, or that and a scale");
  const glm::dvec3 rgb = rgb_of_blackbody(numbers[0]);
  if (numbers.size() == 2) return numbers[1] * rgb;
  const double y = luminance(rgb);
  return y > 0 ? rgb / y : rgb;
}

glm::dvec3 of_numbers(const Parameters::Entry& entry, const std::string& what, ColourUse use) {
  const auto& numbers = std::get<std::vector<double>>(entry.value);
  if (entry.type == "blackbody") return of_blackbody(numbers, entry.place);
  if (entry.type == "spectrum") return of_spectrum(pairs(numbers, entry.place, what), use);
  if (numbers.size() == 1) return glm::dvec3(numbers[0]);
  if (numbers.size() != 3) throw InputError(entry.place, what + " must be one number or three");
  const glm::dvec3 rgb(numbers[0], numbers[1], numbers[2]);
  return entry.type == "xyz" ? rgb_of_xyz(rgb) : rgb;
}

}  // namespace

const Parameters::Entry* find_entry(const Parameters& parameters, const std::string& name) {
  const auto found = parameters.entries.find(name);
  return found == parameters.entries.end() ? nullptr : &found->second;
}

std::optional<glm::dvec3> read_colour(const Parameters& parameters, const std::string& name, ColourUse use) {
  const Parameters::Entry* entry = find_entry(parameters, name);
  if (!entry || entry->type == "texture") return std::nullopt;
  const std::string what = fmt::format("\"{} {}\"", entry->type, name);
  const auto* names = std::get_if<std::vector<std::string>>(&entry->value);
  const bool is_named = names && entry->type == "spectrum" && names->size() == 1;
  if (!is_named && !std::holds_alternative<std::vector<double>>(entry->value))
    throw InputError(entry->place, what + " must be a colour");
  const glm::dvec3 colour = is_named ? of_name(*entry, what, use) : of_numbers(*entry, what, use);
  for (int c = 0; c < 3; ++c) {
    if (!(colour[c] <= kLargest)) throw InputError(entry->place, what + " is too large");
  }
  return glm::max(colour, glm::dvec3(0));
}

glm::dvec3 read_colour(const Parameters& parameters, const std::string& name, ColourUse use,
                       const glm::dvec3& fallback) {
  return read_colour(parameters, name, use).value_or(fallback);
}

double read_number(const Parameters& parameters, const std::string& name, double fallback, double least) {
  const Parameters::Entry* entry = find_entry(parameters, name);
  if (!entry || entry->type == "texture") return fallback;
  const double value = parameters.number(name, fallback);
  if (!(value >= least))
    throw InputError(entry->place, fmt::format("\"{}\" must be {} or more", name, least));
  if (!(value <= kLargest)) throw InputError(entry->place, fmt::format("\"{}\" is too large", name));
  return value;
}

}  // namespace capcon
