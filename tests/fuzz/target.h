#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace capcon::fuzz {

/// A promise of a reader that an input broke: the fuzzer stops with it, the test of the corpora fails.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool condition, const char* promise) {
  if (!condition) throw Broken(promise);
}

/// One format: reads the bytes with the program's own reader and checks what it promises of the value.
struct Target {
  std::string_view name;  ///< of the folder in corpus/ and of the dictionary in dictionaries/
  void (*read)(std::string_view bytes);
};

/// All of them, from the files *_targets.cpp.
std::span<const Target> targets();
/// nullptr when there is none.
const Target* find_target(std::string_view name);

/// The contract of every reader: any bytes give a value that keeps its promises, or an InputError or Failure
/// of one sentence in one line. Broken, or whatever else was thrown, goes on to the caller.
void check(const Target& target, std::string_view bytes);

void read_pbrt(std::string_view bytes);
void read_ply(std::string_view bytes);
void read_obj(std::string_view bytes);
void read_cornell(std::string_view bytes);
void read_merl(std::string_view bytes);
void read_spectrum(std::string_view bytes);
void read_exr_image(std::string_view bytes);
void read_png_image(std::string_view bytes);
void read_partial(std::string_view bytes);
void read_points_text(std::string_view bytes);
void read_points_csv(std::string_view bytes);
void read_points_binary(std::string_view bytes);
void read_points_npy(std::string_view bytes);
void read_formula(std::string_view bytes);
void read_ensembles(std::string_view bytes);
void read_tiles(std::string_view bytes);
void read_parts(std::string_view bytes);
void read_study_runs(std::string_view bytes);
void read_study_baseline(std::string_view bytes);
void read_kept_study(std::string_view bytes);
void read_study_shard(std::string_view bytes);
void read_close_up_facts(std::string_view bytes);
void read_serve_settings(std::string_view bytes);
void read_sealed(std::string_view bytes);

}  // namespace capcon::fuzz
