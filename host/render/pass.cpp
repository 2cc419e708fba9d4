#include "render/pass.h"

#include <bit>

namespace capcon {

glm::vec4 with_word(const glm::dvec3& v, std::uint32_t w) {
  return {glm::vec3(v), std::bit_cast<float>(w)};
}

Pass::Pass(RendererState& state, int first_row, int rows, int channels,
           const std::function<void(double)>& on_progress)
    : s_(state), on_progress_(on_progress), batches_(state.batches()) {
  const auto width = static_cast<std::uint32_t>(state.film.width);
  first_ = width * static_cast<std::uint32_t>(first_row);
  pixels_ = width * static_cast<std::uint32_t>(rows);
  result_.image = Image(state.film.width, rows, channels);
  result_.device = state.description.name;
}

void Pass::primary(const gpu::Kernel& kernel, const SamplerTables& tables, bool jittered, std::uint32_t seed,
                   std::uint32_t count, std::uint32_t sample_index) {
  layout::PrimaryConstants push{};
  push.tree = s_.tree;
  push.tree.grid_scale.w = static_cast<float>(s_.view.start);
  push.eye = with_word(s_.view.first, static_cast<std::uint32_t>(s_.film.width));
  push.across = with_word(s_.view.across, band_);
  push.down = with_word(s_.view.down, jittered ? 1 : 0);
  push.words = words(tables);
  push.seed = seed;
  push.count = count;
  push.sample_index = sample_index;
  each_piece([&] { return batches_.lanes(kernel); },
             [&](std::uint32_t first, std::uint32_t pixels) {
               push.first_pixel = band_ + first;
               push.corner = with_word(s_.view.corner, pixels);
               submit(kernel, &push, groups_for(pixels), "primary");
             });
}

void Pass::submit(const gpu::Kernel& kernel, const void* push, std::uint32_t groups, const std::string& stage,
                  std::uint64_t lanes) {
  const auto start = Clock::now();
  gpu::Commands commands(s_.device);
  commands.dispatch(kernel, push, groups, stage);
  commands.submit_and_wait();
  for (const auto& time : commands.times()) {
    result_.timings.device[time.stage] += time.seconds;
    batches_.took(kernel, lanes, time.seconds);
  }
  result_.timings.wall[stage] += seconds_since(start);
  if (on_progress_) on_progress_(fraction_);
}

void Pass::put(std::size_t value, double sum, double more, const SampleShare& share, std::uint32_t samples) {
  if (share.whole()) {
    result_.image.pixels[value] = static_cast<float>(sum / samples + more);
    return;
  }
  result_.samples = samples;
  result_.sums.resize(result_.image.pixels.size());
  result_.sums[value] = sum + more * samples;
}

void Pass::progress(double lanes, double all) {
  done_ += lanes;
  fraction_ = done_ / all;
  if (on_progress_) on_progress_(fraction_);
}

glm::uvec4 Pass::words(const SamplerTables& t) {
  return {t.constants[0], t.constants[1], t.constants[2], t.constants[3]};
}

}  // namespace capcon
