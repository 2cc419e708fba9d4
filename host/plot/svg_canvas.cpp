#include "plot/svg_canvas.h"

#include <fmt/format.h>

#include "plot/indexed_png.h"

namespace capcon::plot {
namespace {

std::string hex(Colour c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

/// Hundredths of a pixel, without zeros that say nothing.
std::string number(double v) {
  std::string text = fmt::format("{:.2f}", v);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string path_data(std::span<const glm::dvec2> points) {
  std::string data;
  for (const glm::dvec2& p : points)
    data += fmt::format("{}{} {}", data.empty() ? "M" : "L", number(p.x), number(p.y));
  return data;
}

/// Text of an element; control characters, which XML forbids, become '?'.
std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += static_cast<unsigned char>(c) < 32 ? '?' : c;
  }
  return result;
}

/// RFC 4648.
std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(c);
    for (held += 8; held >= 6;) text += kDigits[bits >> (held -= 6) & 63];
  }
  if (held > 0) text += kDigits[bits << (6 - held) & 63];
  while (text.size() % 4 != 0) text += '=';
  return text;
}

}  // namespace

SvgCanvas::SvgCanvas(double width, double height, Colour background)
    : body_(fmt::format(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
          "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
          "font-family=\"system-ui,'Segoe UI',Roboto,'Helvetica Neue','DejaVu Sans',sans-serif\">\n",
          number(width), number(height))) {
  rectangle({0, 0, width, height}, background);
}

void SvgCanvas::polygon(std::span<const glm::dvec2> corners, Colour fill) {
  body_ += fmt::format("<path d=\"{}Z\" fill=\"{}\"/>\n", path_data(corners), hex(fill));
}

void SvgCanvas::polyline(std::span<const glm::dvec2> points, const Stroke& stroke) {
  body_ += fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{}/>\n",
      path_data(points), hex(stroke.colour), number(stroke.width),
      stroke.dash > 0 ? fmt::format(" stroke-dasharray=\"{}\"", number(stroke.dash)) : "");
}

void SvgCanvas::disc(glm::dvec2 centre, double radius, Colour fill) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", number(centre.x),
                       number(centre.y), number(radius), hex(fill));
}

void SvgCanvas::text(glm::dvec2 at, std::string_view text, const TextStyle& style) {
  static constexpr const char* kAnchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
  const std::string place =
      style.upwards ? fmt::format("transform=\"translate({} {}) rotate(-90)\"", number(at.x), number(at.y))
                    : fmt::format("x=\"{}\" y=\"{}\"", number(at.x), number(at.y));
  body_ += fmt::format("<text {} font-size=\"{}\" fill=\"{}\"{}{}>{}</text>\n", place, number(style.size),
                       hex(style.colour), kAnchors[int(style.anchor)],
                       style.bold ? " font-weight=\"600\"" : "", escape(text));
}

void SvgCanvas::image(const Box& box, const Pixels& pixels) {
  body_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "style=\"image-rendering:pixelated\" xlink:href=\"data:image/png;base64,{}\"/>\n",
      number(box.x), number(box.y), number(box.width), number(box.height), base64(encode_png(pixels)));
}

void SvgCanvas::begin_clip(const Box& box) {
  body_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
      "<g clip-path=\"url(#clip{0})\">\n",
      ++clips_, number(box.x), number(box.y), number(box.width), number(box.height));
}

void SvgCanvas::end_clip() {
  body_ += "</g>\n";
}

}  // namespace capcon::plot
