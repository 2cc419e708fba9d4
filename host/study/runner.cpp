#include "study/runner.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/stop.h"
#include "image/compare.h"
#include "image/flip.h"
#include "study/coarse.h"
#include "study/study_work.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int kCalibrations = 5;  // renders, of which the middle one's time counts

constexpr std::uint32_t kCostOfARender =
    8;  // what a render costs besides its samples, in samples; for the bar alone

double stage(const std::map<std::string, double>& seconds, const char* name) {
  const auto found = seconds.find(name);
  return found == seconds.end() ? 0 : found->second;
}

double device_seconds(const Timings& timings) {
  const auto add = [](double sum, const auto& entry) { return sum + entry.second; };
  if (!timings.device.empty()) return std::accumulate(timings.device.begin(), timings.device.end(), 0.0, add);
  // The oracle has no clock of its own: all that it did but making points.
  return std::accumulate(timings.wall.begin(), timings.wall.end(), 0.0, add) - stage(timings.wall, "points") -
         stage(timings.wall, "compile");
}

/// What was measured, and its image.
struct Measured {
  RunRecord record;
  Image image;
};

Measured measure(const PlannedRun& run, const StudySettings& settings, const RenderJob& render,
                 const ReferenceImage& reference) {
  const auto start = std::chrono::steady_clock::now();
  RenderResult result = render(make_job(settings, run));
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
  const Comparison error = compare(result.image, reference.image);
  if (error.non_finite > 0) {
    throw Failure(
        fmt::format("{} of the pixels rendered with {} at {} {} are not finite numbers; render it with "
                    "--device reference to compare",
                    error.non_finite, run.sampler, run.samples, words_of(settings.integral).many));
  }
  RunRecord record;
  record.run = run;
  record.mse = error.mse;
  record.mse_trimmed = error.mse_trimmed;
  record.relmse = error.relmse;
  record.flip = flip(result.image, reference.image);
  record.mse_coarse = coarse_mse(result.image, reference.image);
  record.rays = result.rays;
  record.device_seconds = device_seconds(result.timings);
  record.wall_seconds = std::max(0.0, whole.count() - stage(result.timings.wall, "compile"));
  record.point_generation_seconds = stage(result.timings.wall, "points");
  record.timings = result.timings;
  record.device = result.device;
  return {std::move(record), std::move(result.image)};
}

void check_folder(const fs::path& folder) {
  create_folder(folder);
  for (const char* name : {"runs.jsonl", "reference.exr", "study.json", "report.html"})
    check_writable(folder / name);
}

}  // namespace

RunImages run_images(const fs::path& directory, const std::string& hash) {
  return {directory / "images", hash};
}

json study_header(const StudySettings& settings, const json& device, const std::string& hash) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return {{"study", words_of(settings.integral).slug},
          {"format", 1},
          {"settings_hash", hash},
          {"settings", to_json(settings)},
          {"device", device},
          {"version", version()},
          {"started", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(now))}};
}

StudyWork::StudyWork(const StudySettings& settings, const StudyDevice& device, const RunnerOptions& options,
                     RunLog* log, std::vector<PlannedRun> plan)
    : settings_(settings),
      options_(options),
      log_(log),
      plan_(std::move(plan)),
      done_runs_(static_cast<std::size_t>(std::count_if(
          plan_.begin(), plan_.end(), [&](const PlannedRun& run) { return log->find(run) != nullptr; }))),
      progress_("study", total(), options.quiet),
      stop_(kept()) {
  // A device that is lost or has no room: what is finished stays.
  render_ = [this, &device](const Job& job) {
    try {
      return device.render(job);
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{}; {}", failure.what(), kept()));
    }
  };
}

double StudyWork::total() const {
  double sum = settings_.reference_groups * (settings_.reference_samples + kCostOfARender);
  for (const PlannedRun& run : plan_) sum += run.samples + kCostOfARender;
  return sum;
}

std::string StudyWork::kept() const {
  return fmt::format("{} of {} runs are kept in {}, and the same command goes on from there", done_runs_,
                     plan_.size(), options_.directory.string());
}

void StudyWork::step(std::uint32_t samples, const std::string& note) {
  done_ += samples + kCostOfARender;
  if (!note.empty()) progress_.update(done_, note);
  stop_.say(kept());
}

Image StudyWork::reference_group(std::uint32_t group) {
  Image image = render_(make_reference_job(settings_, group)).image;
  step(settings_.reference_samples, "reference image");
  return image;
}

void StudyWork::reference_was_there() {
  for (std::uint32_t g = 0; g < settings_.reference_groups; ++g) step(settings_.reference_samples, "");
}

void StudyWork::measure_all(StudyResult& result, const RunImages* images, const RunRecord& by) {
  std::set<std::string> warm;  // kernels are compiled on first use: a render that does not count comes before
  for (const PlannedRun& run : plan_) {
    if (const RunRecord* finished = log_->find(run)) {
      result.records.push_back(*finished);
      ++result.resumed;
      // The same input gives the same bits: an image that was removed comes again, and nothing is timed.
      if (images && !images->read(run)) images->write(run, render_(make_job(settings_, run)).image);
      step(run.samples, "");
      continue;
    }
    if (warm.insert(run.sampler).second)
      render_(make_job(settings_, {run.sampler, settings_.samples.front(), 0}));
    Measured measured = measure(run, settings_, render_, result.reference);
    measured.record.process = by.process;
    measured.record.calibration_seconds = by.calibration_seconds;
    if (images) images->write(run, measured.image);  // first: a line in runs.jsonl has its image
    log_->append(measured.record);
    ++done_runs_;
    result.records.push_back(std::move(measured.record));
    step(run.samples, fmt::format("{} at {} {}, seed {}", run.sampler, run.samples,
                                  words_of(settings_.integral).many, run.seed));
  }
}

double StudyWork::calibration_seconds() {
  const Job job =
      make_job(settings_, {kReferenceSampler, settings_.samples[settings_.samples.size() / 2], 0});
  render_(job);
  std::vector<double> seconds;
  for (int i = 0; i < kCalibrations; ++i) seconds.push_back(device_seconds(render_(job).timings));
  std::nth_element(seconds.begin(), seconds.begin() + kCalibrations / 2, seconds.end());
  return std::max(1e-9, seconds[kCalibrations / 2]);
}

StudyResult run_study(const StudySettings& settings, const StudyDevice& device,
                      const RunnerOptions& options) {
  check_folder(options.directory);
  const std::string hash = settings_hash(settings, device.info);
  RunLog log(options.directory / "runs.jsonl", study_header(settings, device.info, hash), options.fresh);
  StudyResult result{settings, device.info, log.header().value("started", ""), std::string(version()), {}, {},
                     0,        log.moved()};
  StudyWork work(settings, device, options, &log, plan_runs(settings));
  const fs::path reference_path = options.directory / "reference.exr";
  if (auto before = options.fresh ? std::nullopt : read_reference(reference_path, hash)) {
    result.reference = std::move(*before);
    work.reference_was_there();
  } else {
    std::vector<Image> groups;
    for (std::uint32_t g = 0; g < settings.reference_groups; ++g) groups.push_back(work.reference_group(g));
    result.reference = combine_groups(groups);
    write_reference(reference_path, result.reference, settings, hash);
  }
  std::optional<RunImages> images;
  if (keeps_images(settings.integral)) images = run_images(options.directory, hash);
  work.measure_all(result, images ? &*images : nullptr);
  return result;
}

}  // namespace capcon
