// Where a 2D point comes from. One file a sampler; the specialisation constant leaves the others out of the kernel.
layout(constant_id = kSpecSampler) const uint kSampler = kSamplerRandom;
DATA_TEXELS(kBindSampler, sampler_texels);

#include "sampling/hash.glsl"
#include "sampling/bits.glsl"
#include "sampling/random.glsl"
#include "sampling/jittered.glsl"
#include "sampling/sobol.glsl"
#include "sampling/rotated_set.glsl"
#include "sampling/corner_tiles.glsl"
#include "sampling/domain_set.glsl"

// Point `index` of the set of `count` points of (pixel, dimension pair): 0.32 fixed point.
uvec2 sample_bits(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  if (kSampler == kSamplerJittered) return sample_jittered(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerSobolXor) return sample_sobol(false, words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerSobolOwen) return sample_sobol(true, words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCcvt) return sample_rotated_set(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCapcon) return sample_corner_tiles(words, seed, count, pixel, index, dimension);
  if (kSampler == kSamplerCapconDomain) return sample_domain_set(words, seed, count, pixel, index, dimension);
  return sample_random(seed, pixel, index, dimension);
}

// The upper 24 bits as a float in [0, 1): exact.
vec2 unit_floats(uvec2 bits) { return vec2(bits >> 8u) * 5.9604644775390625e-8; }
