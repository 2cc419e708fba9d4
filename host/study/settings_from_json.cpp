#include <algorithm>
#include <charconv>
#include <limits>

#include "base/error.h"
#include "study/json_numbers.h"
#include "study/merge.h"

namespace capcon {
namespace {

std::uint64_t hexadecimal(const nlohmann::json& json, const char* name) {
  const auto text = json.at(name).get<std::string>();
  std::uint64_t value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value, 16).ec != std::errc())
    throw InputError(std::string(name) + " is no fingerprint");
  return value;
}

Integral integral_of(const std::string& slug) {
  for (const Integral integral :
       {Integral::ambient_occlusion, Integral::direct, Integral::splitting, Integral::global_illumination}) {
    if (words_of(integral).slug == slug) return integral;
  }
  throw InputError(slug + " is no study");
}

Clamping clamping_of(const std::string& name) {
  for (const Clamping clamping : {Clamping::none, Clamping::clamp}) {
    if (clamping_name(clamping) == name) return clamping;
  }
  return Clamping::compensate;
}

}  // namespace

StudySettings settings_from_json(const nlohmann::json& json) {
  StudySettings s;
  s.integral = integral_of(json.at("integral").get<std::string>());
  s.combined = whole<std::uint32_t>(json, "combined");
  s.position = json.at("pixel_samples") == "jittered" ? PixelPosition::jittered : PixelPosition::centre;
  s.scene = json.at("scene").get<std::string>();
  s.scene_fingerprint = hexadecimal(json, "scene_fingerprint");
  s.points_fingerprint = hexadecimal(json, "points_fingerprint");
  s.unique_triangles = whole<std::uint64_t>(json, "unique_triangles");
  s.instanced_triangles = whole<std::uint64_t>(json, "instanced_triangles");
  s.width = whole(json, "width", 1);
  s.height = whole(json, "height", 1);
  s.radius = json.at("radius").is_number() ? json.at("radius").get<double>()
                                           : std::numeric_limits<double>::infinity();
  s.samplers = json.at("samplers").get<std::vector<std::string>>();
  if (json.contains("point_files")) {
    for (const auto& [name, file] : json.at("point_files").items())
      s.point_files[name] = {file.at("sampler").get<std::string>(), hexadecimal(file, "fingerprint")};
  }
  if (!json.at("samples").is_array()) throw InputError("samples are no list");
  s.samples.clear();
  for (const auto& count : json.at("samples")) s.samples.push_back(whole<std::uint32_t>(count));
  s.seeds = whole<std::uint32_t>(json, "seeds", 1);
  s.reference_samples = whole<std::uint32_t>(json, "reference_samples");
  s.reference_groups = whole<std::uint32_t>(json, "reference_groups");
  s.close_ups = json.at("close_ups").get<bool>();
  s.command = json.at("command").get<std::string>();
  if (s.integral == Integral::global_illumination) {
    s.paths = whole<std::uint32_t>(json, "paths", 1);
    s.limit = json.at("limit").get<double>();
    s.clamping = clamping_of(json.at("clamping").get<std::string>());
  }
  if (s.samplers.empty() || s.samples.empty()) throw InputError("a study of nothing");
  return s;
}

}  // namespace capcon
