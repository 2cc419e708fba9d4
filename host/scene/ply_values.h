#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "base/error.h"
#include "scene/number_text.h"
#include "scene/ply_header.h"

namespace capcon {

/// Both sources of PLY values throw these in place of an InputError; who walks the elements knows which
/// record it was.
struct PlyFault {
  std::string what;
};

/// Values of a binary PLY, one after the other.
class PlyBinaryValues {
 public:
  PlyBinaryValues(std::string_view data, bool big_endian) : data_(data), big_endian_(big_endian) {}

  double read(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return take<float>();
      case PlyType::float64:
        return take<double>();
    }
    return 0;
  }
  void skip(PlyType type) { advance(ply_size(type)); }

 private:
  const char* advance(std::size_t size) {
    if (size > data_.size()) throw PlyFault{"the file ends here; is it truncated?"};
    const char* from = data_.data();
    data_.remove_prefix(size);
    return from;
  }
  template <typename T>
  double take() {
    char raw[sizeof(T)];
    const char* from = advance(sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[i] = from[big_endian_ ? sizeof(T) - 1 - i : i];
    T value;
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }

  std::string_view data_;
  bool big_endian_;
};

/// Values of an ascii PLY: words between blanks and line ends, whatever the lines.
class PlyTextValues {
 public:
  explicit PlyTextValues(std::string_view data) : data_(data) {}

  double read(PlyType) {
    double value = 0;
    const std::string_view text = word();
    const NumberText kind = parse_number(text, value);
    if (kind == NumberText::malformed)
      throw PlyFault{'"' + std::string(text.substr(0, 40)) + "\" is not a number"};
    if (kind == NumberText::not_finite)
      throw PlyFault{'"' + std::string(text.substr(0, 40)) + "\" is not a finite number"};
    return value;
  }
  void skip(PlyType) { word(); }

 private:
  std::string_view word() {
    constexpr std::string_view kBlanks = " \t\r\n\f\v";
    data_.remove_prefix(std::min(data_.find_first_not_of(kBlanks), data_.size()));
    if (data_.empty()) throw PlyFault{"the file ends here; is it truncated?"};
    const std::string_view text = data_.substr(0, data_.find_first_of(kBlanks));
    data_.remove_prefix(text.size());
    return text;
  }

  std::string_view data_;
};

}  // namespace capcon
