#pragma once

#include <functional>
#include <string>

#include "distributed/ranks.h"
#include "scene/job.h"

namespace capcon {

/// Renders these rows of a job, as Renderer::render_rows().
using RenderRows = std::function<RenderResult(const Job& job, int first_row, int rows,
                                              const std::function<void(double)>& on_progress)>;

/// One image by all ranks: each renders a share of every pixel's samples (docs/clusters.md). Rank 0 says
/// which rows are wanted; the sums are added up there in the order of the ranks, so that the same number of
/// ranks gives the same bits every time. A rank that is alone renders as it would without all this.
class ShareRenderer {
 public:
  ShareRenderer(const Ranks& ranks, Job job, RenderRows render);
  ShareRenderer(const ShareRenderer&) = delete;
  ShareRenderer& operator=(const ShareRenderer&) = delete;
  /// Rank 0: lets the others go.
  ~ShareRenderer();

  /// Rank 0: the rows' image, with the rays of all; times are its own.
  RenderResult render_rows(int first_row, int rows, const std::function<void(double)>& on_progress);
  /// The others: help until rank 0 is done.
  void help();

 private:
  RenderResult share(int first_row, int rows, const std::function<void(double)>& on_progress);

  const Ranks& ranks_;
  Job job_;
  RenderRows render_;
};

/// The device of a rank: of several numbers, "0,1,3", the one for its number among those on its machine;
/// whatever else is named is for all.
std::string device_of_rank(const std::string& devices, int on_this_machine);
/// Whether so many ranks have no device each.
bool share_a_device(const std::string& devices, int ranks_of_machine);

}  // namespace capcon
