#include "render/sample_points.h"

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
  gpu::Commands commands(state.device);
  const auto groups =
      static_cast<std::uint32_t>((points.size() + layout::kGroupSize - 1) / layout::kGroupSize);
  commands.dispatch(kernel, &push, groups, "points");
  commands.submit_and_wait();
  output.download(points.data(), points.size() * sizeof(FixedPoint));
  return points;
}

}  // namespace capcon
