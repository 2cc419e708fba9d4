#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"

namespace capcon {

/// & < > " ' as entities.
std::string escape(std::string_view text);

/// <img> with the picture inside it. `exposure` as in encode_png; `alt` says what is seen.
std::string embedded_image(const Image& image, float exposure, const std::string& alt);

/// A table with a caption, a header row and a header cell a row. Cells are HTML already.
class HtmlTable {
 public:
  HtmlTable(std::string caption, std::vector<std::string> head)
      : caption_(std::move(caption)), head_(std::move(head)) {}
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  std::string str() const;

 private:
  std::string caption_;
  std::vector<std::string> head_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace capcon
