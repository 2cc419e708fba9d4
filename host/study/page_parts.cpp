#include <fmt/format.h>

#include "study/embedded.h"
#include "study/report.h"

namespace capcon {

std::string_view report_style() {
  return embedded::report_css();
}

std::string_view page_meta() {
  return "<meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
         "<meta name=\"color-scheme\" content=\"light dark\">"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: blob:; "
         "style-src "
         "'unsafe-inline'; script-src 'unsafe-inline'\">";
}

std::string page_scripts() {
  std::string html;
  if (!embedded::dygraphs().empty()) {
    html +=
        fmt::format("<script>/*!\n{}*/\n{}</script>\n", embedded::dygraphs_licence(), embedded::dygraphs());
  }
  for (const auto script : {embedded::charts_js(), embedded::viewer_js(), embedded::page_js()})
    html += fmt::format("<script>\n{}</script>\n", script);
  return html;
}

}  // namespace capcon
