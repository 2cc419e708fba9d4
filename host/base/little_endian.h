#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace capcon {

/// Appends an unsigned number, the lowest byte first whatever the machine's order.
template <class T>
void put_bytes(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

/// Takes such a number off the front; there are enough bytes.
template <class T>
T take_bytes(std::string_view& bytes) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    value |= static_cast<T>(static_cast<T>(static_cast<unsigned char>(bytes[i])) << (8 * i));
  bytes.remove_prefix(sizeof(T));
  return value;
}

}  // namespace capcon
