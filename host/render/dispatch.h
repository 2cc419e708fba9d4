#pragma once

#include <cstdint>

namespace capcon {

/// The most lanes of one dispatch; render/batches.h makes them fewer where they take long. CPU devices gain
/// nothing by more than the second, and a piece of a large scene can cost ten times as much as the one before
/// it.
constexpr std::uint64_t kBatchLanes = 1 << 19, kCpuBatchLanes = 1 << 18;

/// Samples of a pixel in one dispatch, at most, so that one pixel makes no long dispatch.
constexpr std::uint32_t kMostSamples = 1u << 14;

/// Workgroups for so many lanes.
std::uint32_t groups_for(std::uint64_t lanes);

/// A stride that is coprime to the number of groups and near its golden section: a driver that hands each
/// thread one contiguous piece of a dispatch then gives all of them the same mix of work. Stride times group
/// stays below 2^32 (shaders/dispatch.glsl): beyond 65,536 groups the stride is 1.
std::uint32_t spreading_stride(std::uint32_t groups);

}  // namespace capcon
