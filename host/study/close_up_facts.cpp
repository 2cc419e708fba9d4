#include "study/close_up_facts.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "study/json_numbers.h"
#include "study/run_record.h"

namespace capcon {
namespace {

using nlohmann::json;

constexpr std::size_t kMostViews = 1000;

Region region_from(const json& values) {
  if (values.size() != 4) throw std::out_of_range("region");
  return {whole<int>(values.at(0)), whole<int>(values.at(1)), whole<int>(values.at(2), 1),
          whole<int>(values.at(3), 1)};
}

}  // namespace

CloseUpFacts parse_close_up_facts(std::string_view text) {
  const json facts = parse_study_json(text);
  CloseUpFacts result{facts.at("settings_hash").get<std::string>(), {}};
  CloseUps& c = result.close_ups;
  c.picture_samples = whole<std::uint32_t>(facts, "picture_samples");
  c.seed = whole<std::uint32_t>(facts, "seed");
  c.region = region_from(facts.at("region"));
  const double exposure = facts.at("exposure").get<double>();
  if (!(exposure > 1e-30 && exposure < 1e30)) throw std::out_of_range("exposure");
  c.exposure = static_cast<float>(exposure);
  for (const json& count : facts.at("samples")) c.samples.push_back(whole<std::uint32_t>(count, 1));
  for (const json& view : facts.at("views")) {
    c.views.push_back(
        {view.at("sampler").get<std::string>(), whole<std::uint32_t>(view, "samples", 1), {}, {}, 0, 0});
  }
  if (c.samples.empty() || c.views.size() > kMostViews) throw std::out_of_range("samples or views");
  return result;
}

}  // namespace capcon
