#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "serve/settings.h"

namespace capcon::serve {

/// Renders jobs of one scene at one size.
struct Tracer {
  /// Is told how far the job is, several times a second (the reference: after its rows); may throw to end it.
  using OnProgress = std::function<void(double)>;
  std::function<RenderResult(const Job&, const OnProgress&)> render;
  std::string device;  ///< its own name
  int width = 0, height = 0;
};
/// Reads the scene and opens the device; fills in a radius that was left to the scene's size. InputError,
/// Failure.
Tracer open_tracer(Settings& settings);

/// One measured frame.
struct Frame {
  double seconds = 0;  ///< device time
  double mse = 0;      ///< less the reference's own
  double relmse = 0;   ///< the same, of (a - b)^2 / (b^2 + 0.01)
  double rays = 0;
};

/// Everything of one sampler at one count, seeds 1, 2, ...
struct Cell {
  std::uint32_t count = 0;
  std::vector<Frame> frames;
  Image first;  ///< seed 1: what the page shows
};

/// Samplers side by side. One thread calls step(), any number the others.
class Comparison {
 public:
  Comparison(std::string id, Settings settings);

  /// Renders one frame, or one group of the reference; false when all is done, cancelled or failed.
  bool step();
  /// A render under way ends after its next dispatch.
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }
  const std::string& id() const { return id_; }

  /// All that the page shows but images.
  nlohmann::ordered_json snapshot() const;
  /// A sampler's frame of this count (seed 1), or the "reference" so far; nothing where there is none yet.
  std::optional<Image> image(const std::string& sampler, std::uint32_t count) const;

 private:
  static constexpr std::uint32_t kMostGroups = 16;  // of the reference, where they are of full size
  struct Series {
    std::string sampler;
    std::vector<Cell> cells;  ///< by rising count
    double spent = 0;         ///< device seconds
    std::uint32_t frames = 0;
    bool warm = false;
  };
  void work();
  RenderResult render(const Job& job);
  void choose_groups();
  void reference_group();
  void frame(Series& series, Cell& cell);
  Series* next_series();
  Cell* next_cell(Series& series);
  double asked() const;

  const std::string id_;
  Settings settings_;
  std::optional<Tracer> tracer_;  // of the working thread alone
  std::atomic<bool> cancelled_ = false;
  std::atomic<double> fraction_ = 0;  // that is done of the render under way

  mutable std::mutex mutex_;  // of all below
  std::string state_ = "waiting", message_;
  std::string device_;
  int width_ = 0, height_ = 0;
  std::vector<Series> series_;
  std::vector<double> sum_, squares_;  // of the reference's groups
  std::uint32_t groups_ = 0, group_count_ = 0, most_groups_ = kMostGroups;
  std::uint32_t least_groups_ = 4;     // before anything is measured
  std::uint32_t frames_a_group_ = 12;  // it grows meanwhile, one group every so many frames
  Image reference_;
  std::vector<double> reference_variance_;  // of each value of reference_
};

}  // namespace capcon::serve
