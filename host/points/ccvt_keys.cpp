#include "points/ccvt_keys.h"

#include <algorithm>
#include <cstring>

#include "points/ccvt_cells.h"

namespace capcon {

namespace plain {
constexpr int kLanes = 4;
#include "points/ccvt_keys_lanes.h"
}  // namespace plain

#ifdef __x86_64__
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr int kLanes = 8;
#include "points/ccvt_keys_lanes.h"
}  // namespace avx2
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512bw,avx512vl,prefer-vector-width=512")
namespace avx512 {
constexpr int kLanes = 16;
#include "points/ccvt_keys_lanes.h"
}  // namespace avx512
#pragma GCC pop_options
#endif

CcvtKernels plain_ccvt_kernels() {
  return {plain::project, plain::select};
}

CcvtKernels best_ccvt_kernels() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    return {avx512::project, avx512::select};
  if (__builtin_cpu_supports("avx2")) return {avx2::project, avx2::select};
#endif
  return plain_ccvt_kernels();
}

}  // namespace capcon
