#pragma once

#include <string_view>

/// Files of host/study/page, and dygraphs, as they were when the program was built (cmake/embed.cmake).
namespace capcon::embedded {

std::string_view report_css();
std::string_view charts_js();
std::string_view viewer_js();
std::string_view page_js();
std::string_view dygraphs_licence();
/// The chart library; empty where it was not found: then charts are their drawings.
std::string_view dygraphs();

}  // namespace capcon::embedded
