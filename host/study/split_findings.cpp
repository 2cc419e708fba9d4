#include "study/split_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/format.h"

namespace capcon {
namespace {

std::string split_name(const StudySettings& s, std::uint32_t image) {
  return fmt::format("{}x{}", image, s.combined / image);
}

std::string flat_sentence(const StudySettings& s, const Flatness& f) {
  return fmt::format("{} stays within {:.1f} % of its mean, {}, over all splits (farthest at {}).", f.variant,
                     100 * f.farthest, scientific(f.mean), split_name(s, f.at));
}

/// With places of their own, more image samples smooth edges too, and no split is like another.
std::string falling_sentence(const StudySettings& s, const Curve& curve) {
  return fmt::format(
      "{} errs {} at {} and {} at {}: edges are smoothed by image samples, at places of their own.",
      curve.sampler, scientific(curve.cells.front().mse.value), split_name(s, curve.cells.front().samples),
      scientific(curve.cells.back().mse.value), split_name(s, curve.cells.back().samples));
}

/// "1.31 (1.25 to 1.38) at 4x4, ..." of a variant beside another.
std::string ratios_text(const StudySettings& s, const Figures& figures, const std::string& variant,
                        const std::string& baseline) {
  std::vector<std::string> parts;
  for (const std::uint32_t n : s.samples) {
    const Ratio* r = figures.ratio(variant, baseline, n);
    if (r && !std::isnan(r->mse.value))
      parts.push_back(fmt::format("{} at {}", with_range(r->mse), split_name(s, n)));
  }
  return enumerate(parts);
}

}  // namespace

std::vector<Flatness> flatness(const Figures& figures) {
  std::vector<Flatness> all;
  for (const Curve& curve : figures.curves) {
    Flatness f{curve.sampler, 0, 0, 0};
    for (const Cell& cell : curve.cells) f.mean += cell.mse.value / static_cast<double>(curve.cells.size());
    bool sure = !curve.cells.empty();
    for (const Cell& cell : curve.cells) {
      sure = sure && cell.sure;
      const double off = std::abs(cell.mse.value / f.mean - 1);
      if (off >= f.farthest) f.farthest = off, f.at = cell.samples;
    }
    if (sure) all.push_back(f);
  }
  return all;
}

std::vector<std::string> make_split_findings(const StudySettings& s, const Figures& figures) {
  std::vector<std::string> findings;
  std::vector<Flatness> all = flatness(figures);
  // Ours first, then the others; naive ones are told beside what they are naive of.
  std::stable_sort(all.begin(), all.end(), [](const Flatness& a, const Flatness& b) {
    return a.variant.starts_with("capcon") > b.variant.starts_with("capcon");
  });
  for (const Flatness& f : all) {
    if (!parse_variant(f.variant).partition) continue;
    findings.push_back(s.position == PixelPosition::centre ? flat_sentence(s, f)
                                                           : falling_sentence(s, *figures.curve(f.variant)));
  }
  for (const std::string& name : s.samplers) {
    const Variant variant = parse_variant(name);
    if (variant.partition) continue;
    const std::string ratios = ratios_text(s, figures, name, variant.sampler);
    if (!ratios.empty())
      findings.push_back(fmt::format("MSE of {}{} beside that of {} with its sets the parts of one: {}.",
                                     name, variant.factor == 2 ? ", with twice the points," : "",
                                     variant.sampler, ratios));
  }
  for (const std::string& name : s.samplers) {
    if (!name.starts_with("capcon") || !parse_variant(name).partition) continue;
    for (const std::string& baseline : figures.baselines) {
      const std::string ratios = ratios_text(s, figures, name, baseline);
      if (!ratios.empty())
        findings.push_back(fmt::format("MSE of {} beside that of {}: {}.", name, baseline, ratios));
    }
  }
  if (findings.empty())
    findings.push_back("No error of this study is sure; more --reference-samples would settle them.");
  if (s.seeds < 2) findings.push_back("There was one seed only: nothing here says how sure the figures are.");
  return findings;
}

}  // namespace capcon
