#include "image/half_planes.h"

#include <Imath/half.h>

#include "image/deflate.h"

namespace capcon {

std::string half_planes(const std::vector<const Image*>& images) {
  std::string high, low;
  for (const Image* image : images) {
    for (const float v : image->pixels) {
      const unsigned bits = Imath::half(v).bits();
      high += static_cast<char>(bits >> 8);
      low += static_cast<char>(bits & 255);
    }
  }
  return deflated(high + low);
}

}  // namespace capcon
