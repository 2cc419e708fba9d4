#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/statistics.h"
#include "image/image.h"

namespace capcon {

/// & < > " ' as entities.
std::string escape(std::string_view text);

/// <img> with the picture inside it. `exposure` as in encode_png; `alt` says what is seen.
std::string embedded_image(const Image& image, float exposure, const std::string& alt);

/// Text as base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// Comma-separated values (RFC 4180), as tables hand them out.
class Csv {
 public:
  explicit Csv(const std::string& head) : text_(head + '\n') {}
  /// Numbers with all their digits, nothing for what is not finite; texts quoted where they must be.
  Csv& add(double v);
  Csv& add(std::string_view text);
  /// Value, low and high.
  Csv& add(const Interval& v) { return add(v.value).add(v.low).add(v.high); }
  void end_row();
  const std::string& text() const { return text_; }
  /// <a> that hands it out as a file, without scripts too. `what` is for those who cannot see where it
  /// stands.
  std::string link(const std::string& file, const std::string& what) const;

 private:
  void separate();

  std::string text_;
  bool first_ = true;
};

/// <script> that holds JSON or other data: nothing in it ends the element.
std::string data_script(const std::string& attributes, std::string json);

/// A table with a caption, a header row and a header cell a row. Cells are HTML already.
class HtmlTable {
 public:
  HtmlTable(std::string caption, std::vector<std::string> head)
      : caption_(std::move(caption)), head_(std::move(head)) {}
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  /// Hands out these figures with its caption, as `file`.
  void csv(const Csv& csv, const std::string& file) { link_ = csv.link(file, caption_); }
  std::string str() const;

 private:
  std::string caption_, link_;
  std::vector<std::string> head_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace capcon
