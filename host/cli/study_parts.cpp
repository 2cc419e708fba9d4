#include "cli/study_parts.h"

#include <fmt/format.h>

#include "base/error.h"
#include "study/shard.h"
#include "study/study_lock.h"

namespace capcon::cli {

void StudyParts::add_to(CLI::App& study) {
  study.add_option("--shard", shard,
                   "i/n: only the jobs whose number is i modulo n, into DIR/shards; then capcon merge DIR");
  study.add_flag("--only-reference", only_reference,
                 "make the reference image that all shards measure against, and end");
  study.add_option(
      "--check", baseline,
      "study.json of before: exit code 1 where a figure of equal error worsened beyond its interval");
}

void StudyParts::check(const Ranks& ranks) const {
  if (!shard.empty()) Shard::parse(shard);
  if (is_part() && !ranks.alone())
    throw InputError("under mpirun each rank is a shard already: leave out --shard and --only-reference");
  if (!shard.empty() && only_reference)
    throw InputError("--only-reference makes no shard: leave out one of the two");
  if (is_part() && !baseline.empty())
    throw InputError("--check is about a whole study: leave out --shard, and give it to capcon merge");
}

void run_part(const StudyParts& parts, const StudySettings& settings, const MakeStudyDevice& make_device,
              const RunnerOptions& options, const Ranks& ranks) {
  const StudyDevice device = make_device(settings.width, settings.height);
  const std::string study = options.directory.string();
  if (parts.only_reference) {
    shared_reference(settings, device, options, ranks);
    if (!options.quiet)
      fmt::print(stderr, "The reference image is {}\n", (shards_folder(study) / "reference.exr").string());
    return;
  }
  const Shard shard = Shard::parse(parts.shard);
  const StudyLock alone(shard_folder(study, shard));
  const ReferenceImage reference = shared_reference(settings, device, options, ranks);
  const StudyResult result = run_shard(settings, device, options, shard, reference);
  if (options.quiet) return;
  if (!result.moved.empty())
    fmt::print(stderr, "capcon: older runs with other settings are kept in {}\n", result.moved.string());
  fmt::print(stderr, "{} jobs of shard {} are done in {}; when all shards are: capcon merge {}\n",
             result.records.size(), shard.str(), shard_folder(study, shard).string(), study);
}

std::string hold_against(const std::optional<Baseline>& baseline, nlohmann::json& study) {
  if (!baseline) return {};
  const Regression regression = find_regressions(*baseline, study);
  study["check"] = to_json(regression, *baseline);
  std::string lines;
  for (const Worsening& w : regression.worse) lines += sentence(w, study) + '\n';
  const std::string skipped =
      regression.skipped > 0
          ? fmt::format("; {} more have no interval, then or now, and are not compared", regression.skipped)
          : "";
  if (regression.worse.empty()) {
    lines += fmt::format("All {} figures of equal error hold against {}{}\n", regression.compared,
                         baseline->file.string(), skipped);
  }
  return lines;
}

void judge(const std::optional<Baseline>& baseline, const nlohmann::json& study) {
  if (!baseline || study.is_null()) return;
  const std::size_t worse = study.at("check").at("worse").size();
  if (worse == 0) return;
  throw Failure(fmt::format("{} of {} figures of equal error are worse than in {}, beyond their intervals",
                            worse, study.at("check").at("compared").get<std::size_t>(),
                            baseline->file.string()));
}

}  // namespace capcon::cli
