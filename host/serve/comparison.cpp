#include "serve/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "reference/reference.h"
#include "render/features.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "serve/answer.h"
#include "study/plan.h"
#include "study/scene_facts.h"

namespace capcon::serve {
namespace {

constexpr std::uint32_t kSeeds = 32;  // then all is said
constexpr double kBeyond = 1.1;       // of the frame time: curves must reach past it
constexpr double kElsewhere = 0.25;   // of the time at the frame time goes to the rest of a curve

/// Thrown through a render that nobody wants any more.
struct Cancelled {};

double device_seconds(const Timings& timings) {
  double sum = 0;
  for (const auto& [stage, s] : timings.device) sum += s;
  if (!timings.device.empty()) return sum;
  for (const auto& [stage, s] : timings.wall)
    if (stage != "points" && stage != "compile") sum += s;
  return sum;
}

}  // namespace

Tracer open_tracer(Settings& s) {
  const Job first = make_job(s, s.samplers.front(), first_count(s), 1);
  auto scene = std::make_shared<Scene>(read_scene(s.scene.file, needed_reading(first, false)));
  set_film(*scene, s.width, s.height, 0);
  if (s.integrator == "ao" && s.radius == 0)  // as it is shown, and stands in commands
    s.radius = std::stod(fmt::format("{:.4g}", default_radius(*scene)));
  Tracer tracer{{}, s.device, scene->film.width, scene->film.height};
  if (tracer.height > 1024) throw InputError("the film is too high for its width: choose a smaller width");
  if (s.device == "reference") {
    auto reference = std::make_shared<Reference>(*scene);
    tracer.render = [scene, reference](const Job& job, const Tracer::OnProgress& told) {
      return reference->render(job, told);
    };
    return tracer;
  }
  RendererOptions options;
  options.device = s.device;
  options.shading = needs_shading(first);
  auto renderer = std::make_shared<Renderer>(*scene, options);
  tracer.device = renderer->device_info().value("name", s.device);
  tracer.render = [scene, renderer](const Job& job, const Tracer::OnProgress& told) {
    return renderer->render(job, told);
  };
  return tracer;
}

Comparison::Comparison(std::string id, Settings settings)
    : id_(std::move(id)), settings_(std::move(settings)) {
  for (const std::string& sampler : settings_.samplers) {
    Series series;
    series.sampler = sampler;
    series.cells.push_back({first_count(settings_), {}, {}});
    series_.push_back(std::move(series));
  }
}

bool Comparison::step() {
  if (cancelled_) return false;
  try {
    work();
  } catch (const Cancelled&) {
    tracer_.reset();
    return false;
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    state_ = "failed";
    message_ = one_line(error.what());
  }
  const std::lock_guard lock(mutex_);
  if (state_ == "failed" || state_ == "done") tracer_.reset();
  return state_ == "running" || state_ == "opening";
}

void Comparison::work() {
  if (!tracer_) {
    {
      const std::lock_guard lock(mutex_);
      state_ = "opening";
    }
    Settings settings = settings_;
    tracer_ = open_tracer(settings);
    const std::lock_guard lock(mutex_);
    settings_ = settings;
    device_ = tracer_->device;
    width_ = tracer_->width;
    height_ = tracer_->height;
    state_ = "running";
    return;
  }
  std::uint32_t frames = 0;  // only this thread writes what is read here
  for (const Series& series : series_) frames += series.frames;
  if (group_count_ == 0) return choose_groups();
  if (groups_ < least_groups_ || (groups_ < most_groups_ && frames > groups_ * frames_a_group_))
    return reference_group();
  if (Series* series = next_series()) return frame(*series, *next_cell(*series));
  const std::lock_guard lock(mutex_);
  state_ = "done";
}

RenderResult Comparison::render(const Job& job) {
  fraction_ = 0;
  return tracer_->render(job, [this](double fraction) {
    if (cancelled_) throw Cancelled();
    fraction_ = fraction;
  });
}

/// A group of the reference takes about the frame time, so that the first answer does not wait for it: fewer
/// samples than the full number where that takes long, and more groups.
void Comparison::choose_groups() {
  const std::uint32_t full = settings_.integrator == "igi" ? 32 : 256;
  std::uint32_t count = first_count(settings_);
  render(make_job(settings_, kReferenceSampler, count, 0));  // compiles
  for (; count < full; count = std::min(4 * count, full)) {
    const double seconds = device_seconds(render(make_job(settings_, kReferenceSampler, count, 0)).timings);
    if (seconds < settings_.frame_seconds / 32) continue;
    const double fitting = count * std::max(1.0, settings_.frame_seconds / seconds);
    count = std::min(full, std::bit_floor(static_cast<std::uint32_t>(fitting)));
    break;
  }
  const std::lock_guard lock(mutex_);
  group_count_ = count;
  most_groups_ = kMostGroups * (full / count);
  frames_a_group_ = std::max(3u, 12 * count / full);
  // Pixels lit by the same paths err together: more groups until their spread says how much.
  if (settings_.integrator == "igi") least_groups_ = 8;
}

void Comparison::reference_group() {
  const Image image =
      render(make_job(settings_, kReferenceSampler, group_count_, kReferenceSeed + groups_)).image;
  const std::lock_guard lock(mutex_);
  const std::size_t n = image.pixels.size();
  sum_.resize(n);
  squares_.resize(n);
  reference_ = Image(image.width, image.height, image.channels);
  reference_variance_.resize(n);
  const double groups = ++groups_;
  for (std::size_t i = 0; i < n; ++i) {
    const double v = image.pixels[i];
    sum_[i] += v;
    squares_[i] += v * v;
    const double mean = sum_[i] / groups;
    reference_.pixels[i] = static_cast<float>(mean);
    reference_variance_[i] =
        groups < 2 ? 0 : std::max(0.0, squares_[i] / groups - mean * mean) / (groups - 1);
  }
}

Comparison::Series* Comparison::next_series() {
  Series* least = nullptr;
  const auto used = [&](const Series& s) { return settings_.equal_time ? s.spent : double(s.frames); };
  for (Series& series : series_)
    if (next_cell(series) && (!least || used(series) < used(*least))) least = &series;
  return least;
}

/// Counts double until a frame takes longer than the time that is asked about. In equal time the cells around
/// that then get most of the time, since the answer is theirs, and the rest of the curve follows.
Cell* Comparison::next_cell(Series& series) {
  for (Cell& cell : series.cells)
    if (cell.frames.empty()) return &cell;
  const std::size_t needed = settings_.equal_time ? first_needed(series.cells, settings_.frame_seconds) : 0;
  double here = 0, elsewhere = 0;
  Cell *at = nullptr, *rest = nullptr;
  for (std::size_t i = 0; i < series.cells.size(); ++i) {
    Cell& cell = series.cells[i];
    for (const Frame& f : cell.frames) (i < needed ? elsewhere : here) += f.seconds;
    Cell*& fewest = i < needed ? rest : at;
    if (cell.frames.size() < kSeeds && (!fewest || cell.frames.size() < fewest->frames.size()))
      fewest = &cell;
  }
  return rest && (!at || elsewhere < kElsewhere * here) ? rest : at;
}

void Comparison::frame(Series& series, Cell& cell) {
  const auto seed = static_cast<std::uint32_t>(cell.frames.size() + 1);
  if (!series.warm) render(make_job(settings_, series.sampler, cell.count, 0));  // compiles: does not count
  series.warm = true;
  RenderResult result = render(make_job(settings_, series.sampler, cell.count, seed));
  Frame f;
  f.seconds = device_seconds(result.timings);
  f.rays = static_cast<double>(result.rays);
  for (std::size_t i = 0; i < result.image.pixels.size(); ++i) {
    const double b = reference_.pixels[i], d = result.image.pixels[i] - b, e = d * d - reference_variance_[i];
    if (!std::isfinite(e)) throw Failure(series.sampler + " gave a pixel that is not a finite number");
    f.mse += e;
    f.relmse += e / (b * b + 0.01);
  }
  f.mse /= static_cast<double>(result.image.pixels.size());
  f.relmse /= static_cast<double>(result.image.pixels.size());
  const std::lock_guard lock(mutex_);
  cell.frames.push_back(f);
  if (seed == 1) cell.first = std::move(result.image);
  series.spent += f.seconds;
  ++series.frames;
  const Cell& last = series.cells.back();
  if (!last.frames.empty() && last.count * 2 <= largest_count(settings_, series.sampler) &&
      mean_seconds(last) < kBeyond * settings_.frame_seconds)
    series.cells.push_back({last.count * 2, {}, {}});
}

std::optional<Image> Comparison::image(const std::string& sampler, std::uint32_t count) const {
  const std::lock_guard lock(mutex_);
  if (sampler == "reference") return groups_ > 0 ? std::optional(reference_) : std::nullopt;
  for (const Series& s : series_)
    if (s.sampler == sampler)
      for (const Cell& cell : s.cells)
        if (cell.count == count && !cell.first.pixels.empty()) return cell.first;
  return std::nullopt;
}

}  // namespace capcon::serve
