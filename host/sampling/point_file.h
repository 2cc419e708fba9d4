#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sampling/sampler.h"

namespace capcon {

/// A sampler whose points come from a user's file: "file:PATH" with words behind it, "file:net.txt:xor".
/// - shift (default): each (pixel, dimension pair) turns its set on the torus at random: unbiased for any set
/// - xor: random digit scrambling, which keeps digital nets nets: unbiased for any set
/// - none: as they are; several sets are needed, and what is unbiased is the file's own affair
/// - sequence: points come in an order of which any beginning is good; parts of splits are successive points
/// "{n}" in the file's name stands for the number of points asked for.
struct PointFile {
  enum class Randomisation : std::uint8_t { shift, xor_digits, none };

  std::string path;
  Randomisation randomisation = Randomisation::shift;
  bool sequence = false;
};

/// Whether a sampler's name begins with "file:".
bool is_point_file(std::string_view sampler);

/// InputError where no path is given, or words contradict each other.
PointFile parse_point_file(std::string_view sampler);

/// The file is read as import_points reads it. Of its sets those of `count` points are used; where there are
/// none, the first `count` points of all that have more, which are taken for sequences. A (pixel, dimension
/// pair) uses one of them, by hash. Parts: successive points of a sequence and under xor, else the text's
/// partition (part_by_part). InputError as import_points, and where no set has enough points.
std::unique_ptr<Sampler> make_point_file_sampler(std::string_view sampler, std::uint32_t count,
                                                 std::uint32_t seed, std::uint32_t parts);

/// What tables, images and files call a sampler: its name; of a point file the file's name without folder and
/// ending (letters, digits, '.', '_', '-'; 40 of them at most) and its randomisation unless that is the
/// shift.
std::string sampler_label(std::string_view sampler);

/// The same for several: each another, and none the name of a sampler that is not a file.
std::vector<std::string> sampler_labels(const std::vector<std::string>& samplers);

/// InputError unless there is such a sampler, and its file can be read: told before the work.
void check_sampler(std::string_view sampler);

/// A hash of the files behind a sampler, with "{n}" of all there are; 0 where it has none.
std::uint64_t point_file_fingerprint(std::string_view sampler);

}  // namespace capcon
