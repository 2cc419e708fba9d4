#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/explain.h"
#include "study/close_ups.h"
#include "study/figures.h"

namespace capcon {

/// The whole page: one HTML file that loads nothing else. Without scripts it is complete; with them its
/// charts answer to the pointer and zoom, and images are compared under a wipe.
std::string html_report(const StudyResult& result, const Figures& figures,
                        const std::optional<CloseUps>& close_ups,
                        const std::optional<Explanation>& explanation = {});

// Its parts, each a section.

/// Error against samples, beside sobol-owen, against device seconds and against whole seconds.
std::string report_charts(const StudyResult& result, const Figures& figures);
/// MSE, slopes, equal error, equal time.
std::string report_tables(const StudyResult& result, const Figures& figures);
/// Noise and structure of studies that keep the images of their runs: tables and maps.
std::string report_noise(const StudyResult& result, const Figures& figures);
std::string report_close_ups(const StudySettings& settings, const CloseUps& close_ups);
/// What was left out because the job does not need it, and what that saved.
std::string report_explanation(const StudySettings& settings, const Explanation& explanation);
/// What ran, and how each figure is computed.
std::string report_methods(const StudyResult& result, const Figures& figures);
/// Compares the close-ups with the pointer: a place for page/viewer.js, and the images as linear values.
std::string report_viewer(const StudySettings& settings, const CloseUps& close_ups);
/// The style sheet: light and dark, screen and paper.
std::string_view report_style();
/// What goes into <head> of every page: nothing may be loaded from elsewhere.
std::string_view page_meta();
/// What goes to the end of a page: the chart library where it was found at build time, and page/*.js.
std::string page_scripts();

/// Colour and marker of a sampler: known ones always keep theirs, others take those that are left.
int sampler_style(const std::string& sampler, const StudySettings& settings);

}  // namespace capcon
