#include "render/sample_points.h"

#include <algorithm>

namespace capcon {

std::vector<FixedPoint> read_sample_points(RendererState& state, const Sampler& sampler, std::uint32_t pixels,
                                           std::uint32_t dimension, SampleDomain domain) {
  const SamplerTables tables = sampler.tables();
  state.set_sampler(tables);
  std::vector<FixedPoint> points(std::size_t(pixels) * sampler.count());
  gpu::Buffer output(state.device, points.size() * sizeof(FixedPoint), gpu::Memory::host);
  gpu::Kernel& kernel = state.kernel({"points", {{layout::kSpecSampler, tables.id}}});
  kernel.bind(layout::kBindPoints, output);
  layout::PointConstants push{};
  push.words = {tables.constants[0], tables.constants[1], tables.constants[2], tables.constants[3]};
  push.seed = sampler.seed();
  push.split = {sampler.split().parts, sampler.split().points, sampler.split().part_stride,
                sampler.split().point_stride};
  push.pixel_count = pixels;
  push.dimension = dimension;
  push.domain = static_cast<std::uint32_t>(domain);
  Batches batches = state.batches();
  for (std::size_t first = 0, count = 0; first < points.size(); first += count) {
    count = std::min<std::size_t>(batches.lanes(kernel), points.size() - first);
    count = first + count < points.size() ? groups_for(count) * layout::kGroupSize : count;
    push.first = static_cast<std::uint32_t>(first);
    gpu::Commands commands(state.device);
    commands.dispatch(kernel, &push, groups_for(count), "points");
    commands.submit_and_wait();
    batches.took(kernel, count, commands.times().front().seconds);
  }
  output.download(points.data(), points.size() * sizeof(FixedPoint));
  return points;
}

}  // namespace capcon
