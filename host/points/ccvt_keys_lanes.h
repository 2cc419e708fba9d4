// The loops of ccvt_keys.h for kLanes floats at once, included once for each width: in a namespace of its
// own, under the target that has such vectors (GCC splits vectors before it inlines, so that a template would
// be split for the plain target).

using Floats __attribute__((vector_size(4 * kLanes))) = float;
using Words __attribute__((vector_size(4 * kLanes))) = std::int32_t;
using Unsigned __attribute__((vector_size(4 * kLanes))) = std::uint32_t;

float project(const std::uint32_t* x, const std::uint32_t* y, std::uint32_t begin, std::uint32_t end,
              TorusPoint centre, float ux, float uy, float* keys, float largest) {
  Floats best = Floats{} + largest;
  std::uint32_t k = begin;
  for (; k + kLanes <= end; k += kLanes) {
    Unsigned px, py;
    std::memcpy(&px, x + k, sizeof px);
    std::memcpy(&py, y + k, sizeof py);
    const Words dx = (Words)(px - centre.x), dy = (Words)(py - centre.y);
    const Floats key = __builtin_convertvector(dx, Floats) * ux + __builtin_convertvector(dy, Floats) * uy;
    std::memcpy(keys + k, &key, sizeof key);
    best = key > best ? key : best;
  }
  for (; k < end; ++k) {
    keys[k] = static_cast<float>(difference(x[k], centre.x)) * ux +
              static_cast<float>(difference(y[k], centre.y)) * uy;
    largest = std::max(largest, keys[k]);
  }
  for (int lane = 0; lane < kLanes; ++lane) largest = std::max(largest, best[lane]);
  return largest;
}

double sum(const std::uint32_t* x, const std::uint32_t* y, std::uint32_t count, TorusPoint centre,
           std::int64_t& sum_x, std::int64_t& sum_y) {
  using Longs __attribute__((vector_size(8 * kLanes))) = std::int64_t;
  Longs total_x{}, total_y{};
  Words low{}, high{};
  std::int32_t least = 0, most = 0;
  sum_x = sum_y = 0;
  std::uint32_t k = 0;
  for (; k + kLanes <= count; k += kLanes) {
    Unsigned px, py;
    std::memcpy(&px, x + k, sizeof px);
    std::memcpy(&py, y + k, sizeof py);
    const Words dx = (Words)(px - centre.x), dy = (Words)(py - centre.y);
    total_x += __builtin_convertvector(dx, Longs);
    total_y += __builtin_convertvector(dy, Longs);
    const Words lower = dx < dy ? dx : dy, higher = dx < dy ? dy : dx;
    low = lower < low ? lower : low;
    high = higher > high ? higher : high;
  }
  for (; k < count; ++k) {
    const std::int32_t dx = difference(x[k], centre.x), dy = difference(y[k], centre.y);
    sum_x += dx;
    sum_y += dy;
    least = std::min({least, dx, dy});
    most = std::max({most, dx, dy});
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    sum_x += total_x[lane];
    sum_y += total_y[lane];
    least = std::min(least, low[lane]);
    most = std::max(most, high[lane]);
  }
  return std::max(-static_cast<double>(least), static_cast<double>(most));
}

std::uint32_t select(const float* keys, std::uint32_t count, float limit, CcvtCandidate* into) {
  std::uint32_t found = 0, k = 0;
  for (; k + kLanes <= count; k += kLanes) {
    for (std::uint32_t bits = above(keys + k, limit); bits != 0; bits &= bits - 1) {
      const std::uint32_t slot = k + static_cast<std::uint32_t>(std::countr_zero(bits));
      into[found++] = {keys[slot], slot};
    }
  }
  for (; k < count; ++k) {
    if (keys[k] > limit) into[found++] = {keys[k], k};
  }
  return found;
}
