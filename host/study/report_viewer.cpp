#include <algorithm>
#include <nlohmann/json.hpp>

#include "image/half_planes.h"
#include "study/findings.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon {

std::string report_viewer(const StudySettings& settings, const CloseUps& c) {
  const std::string subject = study_subject(settings);
  std::vector<const Image*> images = {&c.reference};
  nlohmann::json names = nlohmann::json::array({{{"name", "reference"}}});
  int left = 0, right = 0;  // today's best known beside what the study is about, at the most samples
  for (const CloseUp& view : c.views) {
    const int place = static_cast<int>(images.size());
    if (view.samples == c.samples.back() && view.sampler == "sobol-owen") left = place;
    if (view.samples == c.samples.back() && view.sampler == subject) right = place;
    images.push_back(&view.crop);
    names.push_back({{"name", view.sampler + ", " + count_label(settings, view.samples)}});
  }
  if (right == 0) right = std::min<int>(1, static_cast<int>(c.views.size()));
  const nlohmann::json facts = {{"width", c.reference.width},
                                {"height", c.reference.height},
                                {"channels", c.reference.channels},
                                {"x", c.region.x},
                                {"y", c.region.y},
                                {"white", 1 / c.exposure},
                                {"left", left},
                                {"right", right},
                                {"images", names}};
  return "<div class=\"viewer\" hidden></div>" +
         data_script("type=\"application/json\" id=\"view-facts\"", facts.dump()) +
         data_script("type=\"text/plain\" id=\"view-pixels\"", base64(half_planes(images)));
}

}  // namespace capcon
