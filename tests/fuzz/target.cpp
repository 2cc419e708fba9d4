#include "fuzz/target.h"

#include <algorithm>

#include "base/error.h"

namespace capcon::fuzz {
namespace {

constexpr Target kTargets[] = {
    {"pbrt", read_pbrt},
    {"ply", read_ply},
    {"obj", read_obj},
    {"cornell", read_cornell},
    {"merl", read_merl},
    {"spectrum", read_spectrum},
    {"exr", read_exr_image},
    {"png", read_png_image},
    {"partial", read_partial},
    {"points", read_points_text},
    {"csv", read_points_csv},
    {"utk", read_points_binary},
    {"npy", read_points_npy},
    {"formula", read_formula},
    {"ensembles", read_ensembles},
    {"tiles", read_tiles},
    {"parts", read_parts},
    {"runs", read_study_runs},
    {"baseline", read_study_baseline},
    {"study", read_kept_study},
    {"shard", read_study_shard},
    {"close-ups", read_close_up_facts},
    {"settings", read_serve_settings},
    {"sealed", read_sealed},
};

constexpr std::size_t kLongestMessage = 1000;

void require_sentence(std::string_view text) {
  require(!text.empty(), "a message says something");
  require(std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
          "a message is one line without control characters");
  require(text.size() < kLongestMessage, "a message does not quote whole files");
}

}  // namespace

std::span<const Target> targets() {
  return kTargets;
}

const Target* find_target(std::string_view name) {
  const auto* found = std::ranges::find(kTargets, name, &Target::name);
  return found == std::end(kTargets) ? nullptr : found;
}

void check(const Target& target, std::string_view bytes) {
  try {
    target.read(bytes);
  } catch (const InputError& error) {
    require_sentence(error.what());
  } catch (const Failure& error) {
    require_sentence(error.what());
  }
}

}  // namespace capcon::fuzz
