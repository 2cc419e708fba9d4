#include "cli/study_samplers.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "sampling/point_file.h"

namespace capcon::cli {
namespace {

std::vector<std::string> default_samplers(Integral integral) {
  if (integral == Integral::splitting)
    return {"capcon", "capcon-naive", "capcon-naive2", "capcon-domain", "sobol-xor", "sobol-owen"};
  if (integral == Integral::global_illumination)
    return {"random", "sobol-xor", "sobol-owen", "halton", "capcon", "capcon-naive", "fpo", "capcon-domain"};
  return default_study_samplers();
}

/// Files of points get a short name each, which tables and files can hold; variants of one file the same.
void name_point_files(StudySettings& s) {
  std::vector<std::string> files;
  for (const std::string& name : s.samplers) {
    const std::string sampler = has_variants(s.integral) ? parse_variant(name).sampler : name;
    if (is_point_file(sampler) && std::find(files.begin(), files.end(), sampler) == files.end())
      files.push_back(sampler);
  }
  const std::vector<std::string> labels = sampler_labels(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    check_sampler(files[i]);
    s.point_files[labels[i]] = {files[i], point_file_fingerprint(files[i])};
    for (std::string& name : s.samplers) {
      const bool same = has_variants(s.integral) ? parse_variant(name).sampler == files[i] : name == files[i];
      if (same) name.replace(0, files[i].size(), labels[i]);
    }
  }
}

}  // namespace

void settle_samplers(StudySettings& s) {
  if (s.samplers.empty()) s.samplers = default_samplers(s.integral);
  name_point_files(s);
  for (std::size_t i = 0; i < s.samplers.size(); ++i) {
    const std::string& name = s.samplers[i];
    const std::string sampler = has_variants(s.integral) ? parse_variant(name).sampler : name;
    if (!s.point_files.contains(sampler)) check_sampler(sampler);  // told before the work
    const auto before = s.samplers.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(s.samplers.begin(), before, name) != before)
      throw InputError(fmt::format("--samplers names {} twice", name));
  }
}

void check_point_files(const StudySettings& s) {
  for (const std::string& name : s.samplers) {
    if (!s.point_files.contains(has_variants(s.integral) ? parse_variant(name).sampler : name)) continue;
    for (const std::uint32_t count : s.samples) {
      const Job job = make_job(s, {name, count, 1});
      if (const auto* ao = std::get_if<AmbientOcclusionJob>(&job)) {
        make_sampler(ao->sampler, ao->samples, 1);
      } else if (const auto* direct = std::get_if<DirectLightingJob>(&job)) {
        make_sampler(direct->sampler, direct->partition ? direct->samples() : direct->integrator_samples, 1);
      } else if (const auto* all = std::get_if<GlobalIlluminationJob>(&job)) {
        make_sampler(all->sampler, all->partition ? all->paths * all->sets : all->paths, 1);
      }
    }
  }
}

}  // namespace capcon::cli
