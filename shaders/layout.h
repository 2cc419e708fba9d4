// Every number that both sides use, compiled by g++ and by glslang. Sizes are asserted in tests.
#ifndef CAPCON_LAYOUT_H
#define CAPCON_LAYOUT_H

#ifdef __cplusplus
#define CAPCON_CONST inline constexpr unsigned
namespace capcon::layout {
#else
#define CAPCON_CONST const uint
#endif

// Sampler ids: SamplerTables::id and the specialisation constant of the kernels.
CAPCON_CONST kSamplerRandom = 0u;
CAPCON_CONST kSamplerJittered = 1u;
CAPCON_CONST kSamplerSobolXor = 2u;
CAPCON_CONST kSamplerSobolOwen = 3u;
CAPCON_CONST kSamplerCcvt = 4u;
CAPCON_CONST kSamplerCapcon = 5u;

#ifdef __cplusplus
}  // namespace capcon::layout
#endif
#undef CAPCON_CONST
#endif
