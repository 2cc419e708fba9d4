// Where a 2D point comes from. One file a sampler; the specialisation constant leaves the others out of the kernel.
layout(constant_id = kSpecSampler) const uint kSamplerVariant = kSamplerRandom;
const uint kSampler = kSamplerVariant & 0xffu;
const bool kInParts = (kSamplerVariant & kSamplerInParts) != 0u;
DATA_TEXELS(kBindSampler, sampler_texels);

#include "sampling/hash.glsl"
#include "sampling/bits.glsl"
#include "sampling/choice.glsl"
#include "sampling/random.glsl"
#include "sampling/jittered.glsl"
#include "sampling/sobol.glsl"
#include "sampling/pmj02.glsl"
#include "sampling/rotated_set.glsl"
#include "sampling/corner_tiles.glsl"
#include "sampling/bounded_tiles.glsl"
#include "sampling/domain_set.glsl"

// Sample `index` of `count` has this place in its set's own order: host/sampling/sampler.h says why they differ.
uint place_in_order(uint count, uint stride, uint index, uint dimension, uint key) {
  bool domain = kSampler == kSamplerCapconDomain || kSampler == kSamplerCapconScreen;
  if (domain && matched_regions(count) > 1u) return matched_place(index, count, dimension == kPairImage, key);
  if (kSampler == kSamplerCapconRanked) return matched_rank(index, ranked_set_points(count), dimension == kPairImage);
  if (domain || kSampler == kSamplerJittered || kSampler == kSamplerCcvt || kSampler == kSamplerCapcon || kSampler == kSamplerCapconBounded)
    return permute(index, count, key);
  return shuffle_index(index, count, stride, key);
}

// The place in a set's own order of its point `index`, in any dimension pair but 0.
uint shuffled(uint seed, uint count, uint stride, uint pixel, uint index, uint dimension) {
  return place_in_order(count, stride, index, dimension, set_words(seed, pixel, dimension, kPurposeSet).z);
}

// The place of part `part`, where they have an order of their own.
uint shuffled_part_only(uint key, uvec4 split, uint part, uint dimension) {
  if (split.y > 1u) return shuffle_index(part, split.x, split.z, key);
  return place_in_order(split.x, split.z, part, dimension, key);
}

// The same for point `index` of part `part`; split: parts, points in a part, and their strides.
uint shuffled_part(uint seed, uvec4 split, uint pixel, uint part, uint index, uint dimension) {
  uint key = set_words(seed, pixel, dimension, kPurposeSet).z;
  if (split.x <= 1u) return place_in_order(split.y, split.w, index, dimension, key);
  if (split.y <= 1u) return place_in_order(split.x, split.z, part, dimension, key);
  return shuffle_index(part, split.x, split.z, key) * split.y +
         shuffle_index(index, split.y, split.w, key + part * 0x9e3779b9u);
}

// The point at place `index` of the set of `count` points of (pixel, dimension pair): 0.32 fixed point.
uvec2 sample_bits(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension, uint domain) {
  if (kSampler == kSamplerJittered) return sample_jittered(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerSobolXor) return sample_sobol(false, words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerSobolOwen) return sample_sobol(true, words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCcvt) return sample_rotated_set(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCapcon) return sample_corner_tiles(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCapconDomain || kSampler == kSamplerCapconScreen || kSampler == kSamplerCapconRanked)
    return sample_domain_set(words, seed, count, pixel, index, dimension, domain);
  if (kSampler == kSamplerSobolZ) return sample_sobol_z(words, seed, pixel, index, dimension);
  if (kSampler == kSamplerPmj02) return sample_pmj02(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCapconBounded) return sample_bounded_tiles(words, seed, count, pixel, index, dimension);
  return sample_random(seed, pixel, index, dimension);
}

// The upper 24 bits as a float in [0, 1): exact.
vec2 unit_floats(uvec2 bits) { return vec2(bits >> 8u) * 5.9604644775390625e-8; }
