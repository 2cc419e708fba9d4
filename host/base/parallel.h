#pragma once

#include <cstddef>
#include <functional>

namespace capcon {

/// Threads that parallel_for uses: $CAPCON_THREADS if set, else the processors this process may run on.
unsigned thread_count();

/// Calls body(i) for every i in [0, count), on all threads, in chunks of `grain`. Results must not depend on
/// the order: each call writes only what belongs to its i. The first exception is thrown again here.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body, std::size_t grain = 1);

}  // namespace capcon
