#include "study/html.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace capcon {
namespace {

/// For the address of a data: URL.
std::string percent_encoded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) || std::strchr(",.-_:/()+", c)) {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return result;
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kAlphabet[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string embedded_image(const Image& image, float exposure, const std::string& alt) {
  return fmt::format("<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">",
                     escape(alt), image.width, image.height, base64(encode_png(image, exposure)));
}

void Csv::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

Csv& Csv::add(double v) {
  separate();
  if (std::isfinite(v)) text_ += fmt::format("{}", v);
  return *this;
}

Csv& Csv::add(std::string_view text) {
  separate();
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    text_ += text;
    return *this;
  }
  text_ += '"';
  for (const char c : text) text_ += c == '"' ? "\"\"" : std::string(1, c);
  text_ += '"';
  return *this;
}

void Csv::end_row() {
  text_ += '\n';
  first_ = true;
}

std::string Csv::link(const std::string& file, const std::string& what) const {
  return fmt::format(
      "<a class=\"csv\" download=\"{}\" href=\"data:text/csv;charset=utf-8,{}\" aria-label=\"CSV of: "
      "{}\">CSV</a>",
      escape(file), percent_encoded(text_), escape(what));
}

std::string data_script(const std::string& attributes, std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
    json.replace(at, 1, "\\u003c");
  return fmt::format("<script {}>{}</script>", attributes, json);
}

std::string HtmlTable::str() const {
  std::string html = fmt::format(
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" "
      "aria-label=\"{}\"><table><caption>{} {}</caption><thead><tr>",
      escape(caption_), escape(caption_), link_);
  for (const std::string& cell : head_) html += "<th scope=\"col\">" + cell + "</th>";
  html += "</tr></thead><tbody>";
  for (const auto& row : rows_) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += i == 0 ? "<th scope=\"row\">" + row[i] + "</th>" : "<td>" + row[i] + "</td>";
    }
    html += "</tr>";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace capcon
