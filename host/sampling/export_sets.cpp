#include "sampling/export_sets.h"

#include <fmt/format.h>

#include <bit>

#include "base/little_endian.h"
#include "points/ensemble_file.h"

namespace capcon {
namespace {

struct Names {
  std::string lower, upper;
  std::uint32_t points;

  Names(const Ensemble& e, EnsembleDomain domain)
      : points(static_cast<std::uint32_t>(e.cells.size() / e.sets)) {
    lower = fmt::format("capcon_{}_{}", domain_name(domain), points);
    for (const char c : lower) upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
};

constexpr const char* kWhat =
    "{0} sets of {1} points in the {2}: cells of a grid of {3} x {4}, each in one set. Take a random set, "
    "one of the 8\n"
    "symmetries, the same for all points of the set, and a random point in each cell: unbiased for any "
    "integrand.";

std::string what(const Ensemble& e, EnsembleDomain domain, std::uint32_t points) {
  std::string text = fmt::format(fmt::runtime(kWhat), e.sets, points, domain_name(domain), e.columns, e.rows);
  text += domain == EnsembleDomain::disk
              ? "\nPoints of the unit square: Shirley and Chiu's concentric map takes them to the disk."
          : domain == EnsembleDomain::cylinder ? "\nx is the azimuth in turns, y the height: z = 2 y - 1 on "
                                                 "the sphere. A shift of x may be any number."
                                               : "";
  return text;
}

/// Lines of numbers.
template <class Number>
std::string table(std::size_t count, const Number& number) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    text += number(k);
    if (k + 1 < count) text += (k + 1) % 12 == 0 ? ",\n  " : ", ";
  }
  return text;
}

}  // namespace

std::string as_c_header(const Ensemble& e, EnsembleDomain domain) {
  const Names names(e, domain);
  std::string comment = what(e, domain, names.points);
  for (std::size_t at = 0; (at = comment.find('\n', at)) != std::string::npos; at += 4)
    comment.replace(at, 1, "\n * ");
  std::string text = fmt::format("/* {} */\n#ifndef {}_H\n#define {}_H\n\n#include <stdint.h>\n\n", comment,
                                 names.upper, names.upper);
  text += fmt::format(
      "#define {0}_SETS {1}u\n#define {0}_POINTS {2}u\n#define {0}_COLUMNS {3}u\n#define {0}_ROWS {4}u\n\n",
      names.upper, e.sets, names.points, e.columns, e.rows);
  text += "/* Column and row of each cell, set by set. */\n";
  text += fmt::format("static const uint16_t {}_cells[{}][2] = {{\n  ", names.lower, e.cells.size());
  text += table(e.cells.size(), [&](std::size_t k) {
    return fmt::format("{{{}, {}}}", e.cells[k] % e.columns, e.cells[k] / e.columns);
  });
  const char* turning =
      domain == EnsembleDomain::cylinder
          ? "  p[0] += 0.25f * (float)(symmetry >> 1 & 3u);\n  if (p[0] >= 1.0f) p[0] -= 1.0f;\n"
            "  if (symmetry & 1u) p[1] = 1.0f - p[1];\n"
          : "  if (symmetry & 1u) p[0] = 1.0f - p[0];\n  if (symmetry & 2u) p[1] = 1.0f - p[1];\n"
            "  if (symmetry & 4u) {\n    const float x = p[0];\n    p[0] = p[1];\n    p[1] = x;\n  }\n";
  text += fmt::format(
      "\n}};\n\n/* Point `index` of set `set` in the unit square, turned by symmetry 0 ... 7; u, v: random "
      "in [0, 1), new for "
      "each point. */\n"
      "static inline void {0}(uint32_t set, uint32_t symmetry, uint32_t index, float u, float v, float p[2]) "
      "{{\n"
      "  const uint16_t* cell = {0}_cells[set * {1}_POINTS + index];\n"
      "  p[0] = ((float)cell[0] + u) / {1}_COLUMNS;\n  p[1] = ((float)cell[1] + v) / "
      "{1}_ROWS;\n{2}}}\n\n#endif\n",
      names.lower, names.upper, turning);
  return text;
}

std::string as_glsl(const Ensemble& e, EnsembleDomain domain) {
  const Names names(e, domain);
  std::string comment = what(e, domain, names.points);
  for (std::size_t at = 0; (at = comment.find('\n', at)) != std::string::npos; at += 4)
    comment.replace(at, 1, "\n// ");
  std::string text = fmt::format("// {}\n\n", comment);
  text += fmt::format("const uint {0}_sets = {1}u;\nconst uint {0}_points = {2}u;\n\n", names.lower, e.sets,
                      names.points);
  text += "// Column | row << 16 of each cell, set by set.\n";
  text += fmt::format("const uint {}_cells[{}] = uint[](\n  ", names.lower, e.cells.size());
  text += table(e.cells.size(), [&](std::size_t k) {
    return fmt::format("{}u", e.cells[k] % e.columns | (e.cells[k] / e.columns) << 16);
  });
  const char* turning =
      domain == EnsembleDomain::cylinder
          ? "  p.x = fract(p.x + 0.25 * float(symmetry >> 1u & 3u));\n  return (symmetry & 1u) != 0u ? "
            "vec2(p.x, 1.0 - p.y) : p;\n"
          : "  if ((symmetry & 1u) != 0u) p.x = 1.0 - p.x;\n  if ((symmetry & 2u) != 0u) p.y = 1.0 - p.y;\n"
            "  return (symmetry & 4u) != 0u ? p.yx : p;\n";
  text += fmt::format(
      "\n);\n\n// Point `index` of set `set` in the unit square, turned by symmetry 0 ... 7; within: random "
      "in [0, 1)^2, new for each "
      "point.\n"
      "vec2 {0}(uint set, uint symmetry, uint index, vec2 within) {{\n"
      "  uint cell = {0}_cells[set * {0}_points + index];\n"
      "  vec2 p = (vec2(cell & 0xffffu, cell >> 16u) + within) / vec2({1}.0, {2}.0);\n{3}}}\n",
      names.lower, e.columns, e.rows, turning);
  return text;
}

std::string as_numpy(const Ensemble& e) {
  std::string head = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}, 4), }}", e.sets,
                                 e.cells.size() / e.sets);
  // Magic, version and length take ten bytes; all before the data a multiple of 64, a line's end last.
  while ((10 + head.size() + 1) % 64 != 0) head += ' ';
  head += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  put_bytes(bytes, static_cast<std::uint16_t>(head.size()));
  bytes += head;
  for (const std::uint32_t c : e.cells) {
    for (const double value :
         {double(c % e.columns) / e.columns, double(c / e.columns) / e.rows, 1.0 / e.columns, 1.0 / e.rows})
      put_bytes(bytes, std::bit_cast<std::uint64_t>(value));
  }
  return bytes;
}

}  // namespace capcon
