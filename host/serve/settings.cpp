#include "serve/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "sampling/sampler.h"

namespace capcon::serve {
namespace {

using nlohmann::json;

double number(const json& j, const char* name, double usual, double least, double most) {
  if (!j.contains(name)) return usual;
  if (!j[name].is_number()) throw InputError(fmt::format("\"{}\" must be a number", name));
  const double value = j[name].get<double>();
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("\"{}\" must be between {} and {}", name, least, most));
  return value;
}

int whole(const json& j, const char* name, int usual, int least, int most) {
  const double value = number(j, name, usual, least, most);
  if (value != static_cast<int>(value)) throw InputError(fmt::format("\"{}\" must be a whole number", name));
  return static_cast<int>(value);
}

std::string text(const json& j, const char* name, const std::string& usual) {
  if (!j.contains(name)) return usual;
  const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  const std::string value = j[name].is_string() ? j[name].get<std::string>() : std::string(201, ' ');
  if (value.size() > 200 || std::any_of(value.begin(), value.end(), control))
    throw InputError(fmt::format("\"{}\" must be a short text", name));
  return value;
}

std::string one_of(const json& j, const char* name, const std::vector<std::string>& choices) {
  const std::string value = text(j, name, choices.front());
  if (std::find(choices.begin(), choices.end(), value) == choices.end())
    throw InputError(fmt::format("\"{}\" must be one of: {}", name, fmt::join(choices, ", ")));
  return value;
}

/// For a shell: as it is where that is safe, else in single quotes.
std::string quoted(const std::string& word) {
  const auto safe = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("/._-").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), safe)) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

Settings parse_settings(const json& j, const std::vector<OfferedScene>& scenes) {
  static const std::set<std::string> known = {"client", "scene",  "integrator",   "samplers",
                                              "device", "radius", "split",        "width",
                                              "height", "mode",   "frame_seconds"};
  if (!j.is_object()) throw InputError("the request must be a JSON object");
  for (const auto& [key, value] : j.items())
    if (!known.contains(key)) throw InputError(fmt::format("\"{}\" is not a setting", one_line(key)));
  Settings s;
  const std::string name = text(j, "scene", scenes.empty() ? "" : scenes.front().name);
  const auto scene =
      std::find_if(scenes.begin(), scenes.end(), [&](const auto& o) { return o.name == name; });
  if (scene == scenes.end())
    throw InputError(fmt::format("there is no scene \"{}\" to choose", one_line(name)));
  s.scene = *scene;
  s.integrator = one_of(j, "integrator", {"ao", "direct", "igi"});
  s.equal_time = one_of(j, "mode", {"equal-time", "equal-samples"}) == "equal-time";
  s.device = text(j, "device", "best");
  s.radius = number(j, "radius", 0, 0, 1e9);
  s.frame_seconds = number(j, "frame_seconds", 2, 0.01, 60);
  s.width = whole(j, "width", 240, 16, 640);
  s.height = whole(j, "height", 0, 0, 480);
  s.split = static_cast<std::uint32_t>(whole(j, "split", 1, 1, 16));
  if (!std::has_single_bit(s.split)) throw InputError("\"split\" must be 1, 2, 4, 8 or 16");
  if (!j.contains("samplers") || !j["samplers"].is_array() || j["samplers"].size() < 2 ||
      j["samplers"].size() > 6)
    throw InputError("\"samplers\" must be a list of two to six samplers");
  for (const json& sampler : j["samplers"]) {
    if (!sampler.is_string()) throw InputError("\"samplers\" must be a list of names");
    const auto& known_names = sampler_names();
    const std::string one = sampler.get<std::string>();
    if (std::find(known_names.begin(), known_names.end(), one) == known_names.end())
      throw InputError(fmt::format("there is no sampler \"{}\"; there are: {}", one_line(one),
                                   fmt::join(known_names, ", ")));
    if (std::find(s.samplers.begin(), s.samplers.end(), one) != s.samplers.end())
      throw InputError(fmt::format("the sampler {} is named twice", one));
    s.samplers.push_back(one);
  }
  return s;
}

Job make_job(const Settings& s, const std::string& sampler, std::uint32_t count, std::uint32_t seed) {
  if (s.integrator == "ao") return AmbientOcclusionJob{s.radius, sampler, count, seed};
  DirectLightingJob direct;
  direct.sampler = sampler;
  direct.seed = seed;
  if (s.integrator == "direct") {
    direct.image_samples = s.split;
    direct.integrator_samples = std::max(1u, count / s.split);
    if (s.split > 1) direct.position = PixelPosition::jittered;
    return direct;
  }
  direct.integrator_samples = 4;
  GlobalIlluminationJob job;
  job.direct = direct;
  job.sampler = sampler;
  job.sets = count;
  return job;
}

std::string command_of(const Settings& s, const std::string& sampler, std::uint32_t count, std::uint32_t seed,
                       int width, int height) {
  std::string c = fmt::format("capcon render {}", quoted(s.scene.file));
  if (s.integrator == "ao") c += fmt::format(" --radius {} --samples {}", s.radius, count);
  if (s.integrator == "direct") {
    c += fmt::format(" --integrator direct --split {}x{}", s.split, std::max(1u, count / s.split));
    if (s.split > 1) c += " --pixel-samples jittered";
  }
  if (s.integrator == "igi") c += fmt::format(" --integrator igi --sets {} --samples 4", count);
  return c + fmt::format(" --sampler {} --seed {} --device {} --width {} --height {} -o {}.exr", sampler,
                         seed, quoted(s.device), width, height, sampler);
}

std::uint32_t largest_count(const Settings& s, const std::string& sampler) {
  if (s.integrator == "igi") return 64;
  return sampler == "ccvt" || sampler == "fpo" ? 256
                                               : 1024;  // sets that are made by optimisation take their time
}

}  // namespace capcon::serve
