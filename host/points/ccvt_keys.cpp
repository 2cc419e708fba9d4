#include "points/ccvt_keys.h"

#include <algorithm>
#include <bit>
#include <cstring>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "points/ccvt_cells.h"

namespace capcon {

namespace plain {
constexpr int kLanes = 4;
inline std::uint32_t above(const float* keys, float limit) {
  std::uint32_t bits = 0;
  for (int lane = 0; lane < kLanes; ++lane) bits |= static_cast<std::uint32_t>(keys[lane] > limit) << lane;
  return bits;
}
#include "points/ccvt_keys_lanes.h"
}  // namespace plain

#ifdef __x86_64__
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr int kLanes = 8;
inline std::uint32_t above(const float* keys, float limit) {
  return static_cast<std::uint32_t>(
      _mm256_movemask_ps(_mm256_cmp_ps(_mm256_loadu_ps(keys), _mm256_set1_ps(limit), _CMP_GT_OQ)));
}
#include "points/ccvt_keys_lanes.h"
}  // namespace avx2
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512bw,avx512vl,prefer-vector-width=512")
namespace avx512 {
constexpr int kLanes = 16;
inline std::uint32_t above(const float* keys, float limit) {
  return _mm512_cmp_ps_mask(_mm512_loadu_ps(keys), _mm512_set1_ps(limit), _CMP_GT_OQ);
}
#include "points/ccvt_keys_lanes.h"
}  // namespace avx512
#pragma GCC pop_options
#endif

CcvtKernels plain_ccvt_kernels() {
  return {plain::project, plain::sum, plain::select};
}

CcvtKernels best_ccvt_kernels() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    return {avx512::project, avx512::sum, avx512::select};
  if (__builtin_cpu_supports("avx2")) return {avx2::project, avx2::sum, avx2::select};
#endif
  return plain_ccvt_kernels();
}

}  // namespace capcon
