#include "plot/glyphs.h"

#include <algorithm>
#include <array>
#include <string>

namespace capcon::plot {
namespace {

// A glyph is its strokes, separated by blanks: a letter for the kind, then pairs of digits x y on a grid
// whose base line is y = 2, x-height 6, height of capitals 8. l = straight lines; c = quadratic B-spline from
// the first to the last point, drawn towards the others; o = closed B-spline within its corners; d = dot.
constexpr const char* kGlyphs[95] = {
    "",                                         // space
    "l0804 d02",                                // !
    "l0806 l2826",                              // "
    "l1238 l3258 l0444 l1656",                  // #
    "c4647270805354443220303 l2921",            // $
    "l0248 o08282606 o24444222",                // %
    "c52142617182838371505120232424344",        // &
    "l0806",                                    // '
    "c19070311",                                // (
    "c09171301",                                // )
    "l2824 l0735 l0537",                        // *
    "l0444 l2622",                              // +
    "l1201",                                    // ,
    "l0434",                                    // -
    "d02",                                      // .
    "l0148",                                    // /
    "o08484202",                                // 0
    "l172822",                                  // 1
    "c0708484502 l0242",                        // 2
    "c0708484515 c154545420203",                // 3
    "l32380444",                                // 4
    "l480805 c050646420203",                    // 5
    "c4748080504 o06464202",                    // 6
    "l084812",                                  // 7
    "o08484505 o05454202",                      // 8
    "o04444808 c0302424546",                    // 9
    "d02 d06",                                  // :
    "d16 l1201",                                // ;
    "l470442",                                  // <
    "l0343 l0545",                              // =
    "l074402",                                  // >
    "c070848452524 d22",                        // ?
    "o25454323 c4544535505080858585452020202",  // @
    "l023862 l1454",                            // A
    "l0208 c082848452505 c052555522202",        // B
    "c575808025253",                            // C
    "l0208 c082858522202",                      // D
    "l48080242 l0535",                          // E
    "l480802 l0535",                            // F
    "c57580802525355 l5535",                    // G
    "l0208 l5258 l0555",                        // H
    "l0208",                                    // I
    "c383432020203",                            // J
    "l0208 l4804 l1542",                        // K
    "l080242",                                  // L
    "l0208346862",                              // M
    "l02085258",                                // N
    "o08585202",                                // O
    "l0208 c082848452505",                      // P
    "o08585202 l3452",                          // Q
    "l0208 c082848452505 l2542",                // R
    "c4748080545420203",                        // S
    "l0848 l2822",                              // T
    "c080402525458",                            // U
    "l082248",                                  // V
    "l0822375268",                              // W
    "l0248 l0842",                              // X
    "l082548 l2522",                            // Y
    "l08480242",                                // Z
    "l19090111",                                // [
    "l0841",                                    // backslash
    "l09191101",                                // ]
    "l062846",                                  // ^
    "l0141",                                    // _
    "l0817",                                    // `
    "o06464202 l4642",                          // a
    "l0208 o06464202",                          // b
    "c454606024243",                            // c
    "l4842 o06464202",                          // d
    "l0444 c444606024243",                      // e
    "c38181612 l0636",                          // f
    "o06464202 c4641400001",                    // g
    "l0208 c0406464442",                        // h
    "l0206 d08",                                // i
    "c16111000 d18",                            // j
    "l0208 l3603 l1432",                        // k
    "c08030212",                                // l
    "l0206 c0406363432 c3436666462",            // m
    "l0206 c0406464442",                        // n
    "o06464202",                                // o
    "l0006 o06464202",                          // p
    "l4046 o06464202",                          // q
    "l0206 c040636",                            // r
    "c3536060434320203",                        // s
    "c18131232 l0636",                          // t
    "c060402424446 l4642",                      // u
    "l062246",                                  // v
    "l0622355266",                              // w
    "l0246 l0642",                              // x
    "l0622 l4610",                              // y
    "l06460242",                                // z
    "c2919150511 c051121",                      // {
    "l0109",                                    // |
    "c0919152511 c251101",                      // }
    "c0405154344",                              // ~
};
constexpr const char* kRoot = "l051632 l3249 l4989";
constexpr const char* kUnknown = "l0208484202";

constexpr double kUnit = 0.72 / 6;  // a step of the grid
constexpr double kGap = 1.9;        // between glyphs, in steps
constexpr int kPieces = 6;          // straight pieces a bend

const char* glyph(std::string_view& text) {
  const auto c = static_cast<unsigned char>(text.front());
  if (text.starts_with("\u221a")) {
    text.remove_prefix(3);
    return kRoot;
  }
  text.remove_prefix(1);
  while (c >= 0x80 && !text.empty() && (static_cast<unsigned char>(text.front()) & 0xC0) == 0x80)
    text.remove_prefix(1);
  return c >= 32 && c < 127 ? kGlyphs[c - 32] : kUnknown;
}

double advance(const char* strokes) {
  if (*strokes == 0) return 3.2;
  if (strokes == kGlyphs['1' - 32]) return 4 + kGap;  // figures stand in columns
  int widest = 0;
  for (const char* s = strokes; *s != 0;) {
    if (*s == ' ' || *s >= 'a') {
      ++s;
    } else {
      widest = std::max(widest, *s - '0');
      s += 2;
    }
  }
  return widest + kGap;
}

void bend(std::vector<glm::dvec2>& line, glm::dvec2 control, glm::dvec2 end) {
  const glm::dvec2 start = line.back();
  for (int k = 1; k <= kPieces; ++k) {
    const double t = double(k) / kPieces;
    line.push_back((1 - t) * (1 - t) * start + 2 * t * (1 - t) * control + t * t * end);
  }
}

std::vector<glm::dvec2> drawn(char kind, const std::vector<glm::dvec2>& points) {
  if (kind == 'l' || kind == 'd' || points.size() < 3) return points;
  const std::size_t n = points.size();
  std::vector<glm::dvec2> line;
  if (kind == 'o') {
    line = {(points[n - 1] + points[0]) * 0.5};
    for (std::size_t k = 0; k < n; ++k) bend(line, points[k], (points[k] + points[(k + 1) % n]) * 0.5);
  } else {
    line = {points[0]};
    for (std::size_t k = 1; k + 1 < n; ++k)
      bend(line, points[k], k + 2 == n ? points[n - 1] : (points[k] + points[k + 1]) * 0.5);
  }
  return line;
}

}  // namespace

double text_width(std::string_view text) {
  double width = 0;
  while (!text.empty()) width += advance(glyph(text));
  return std::max(0.0, width - kGap) * kUnit;
}

std::vector<std::vector<glm::dvec2>> text_strokes(std::string_view text) {
  std::vector<std::vector<glm::dvec2>> strokes;
  double pen = 0;
  while (!text.empty()) {
    const char* const shape = glyph(text);
    for (const char* s = shape; *s != 0;) {
      if (*s == ' ') {
        ++s;
        continue;
      }
      const char kind = *s++;
      std::vector<glm::dvec2> points;
      for (; *s != 0 && *s != ' '; s += 2)
        points.emplace_back((pen + s[0] - '0') * kUnit, (s[1] - '2') * kUnit);
      strokes.push_back(drawn(kind, points));
    }
    pen += advance(shape);
  }
  return strokes;
}

}  // namespace capcon::plot
