// Every binding, push constant and constant that both sides use, compiled by g++ and by glslang. Tests assert the sizes.
#ifndef CAPCON_LAYOUT_H
#define CAPCON_LAYOUT_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
namespace capcon::layout {
using uint = std::uint32_t;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec4;
#define CAPCON_CONST inline constexpr uint
#else
#define CAPCON_CONST const uint
#endif

// Lanes of a workgroup: a multiple of every subgroup size there is.
CAPCON_CONST kGroupSize = 64u;
// And with queues of rays, on CPU devices: they have four lanes, eight or sixteen, and small groups are spread better.
CAPCON_CONST kQueueGroupSize = 16u;

// Sampler ids: SamplerTables::id and the specialisation constant of the kernels.
CAPCON_CONST kSamplerRandom = 0u;
CAPCON_CONST kSamplerJittered = 1u;
CAPCON_CONST kSamplerSobolXor = 2u;
CAPCON_CONST kSamplerSobolOwen = 3u;
CAPCON_CONST kSamplerCcvt = 4u;
CAPCON_CONST kSamplerCapcon = 5u;
CAPCON_CONST kSamplerCapconDomain = 6u;
CAPCON_CONST kSamplerPmj02 = 7u;
CAPCON_CONST kSamplerCapconScreen = 9u;
CAPCON_CONST kSamplerSobolZ = 10u;
CAPCON_CONST kSamplerCapconRanked = 11u;
CAPCON_CONST kSamplerCapconBounded = 8u;
CAPCON_CONST kSamplerInParts = 0x100u;  // or: of sets of capcon-domain and capcon-screen, which come in parts

// Domains of an integral's points: SampleDomain of host/sampling/sampler.h.
CAPCON_CONST kDomainSquare = 0u;
CAPCON_CONST kDomainDisk = 1u;
CAPCON_CONST kDomainCylinder = 2u;

// Dimension pairs of the samplers.
CAPCON_CONST kPairIntegrand = 0u;  // ambient occlusion; direct lighting's BSDF (Y_0)
CAPCON_CONST kPairImage = 1u;      // the place in the pixel
CAPCON_CONST kPairComponent = 2u;  // which component of a BSDF is sampled (sampling/choice.h)
CAPCON_CONST kPairLights = 3u;     // + j: light j (Y_j)
// Of light paths (docs/igi.md), with the bounce in place of a pixel.
CAPCON_CONST kPairOrigin = 0u;     // bounce 0
CAPCON_CONST kPairEmission = 1u;   // bounce 0: direction
CAPCON_CONST kPairGoingOn = 1u;    // later bounces
CAPCON_CONST kPairBounce = 3u;     // later bounces: direction; not pair 0, whose points are in the same order at every bounce
// Of compensation rays from surfaces that are no pixel's.
CAPCON_CONST kPairOnwards = 1u;    // direction; its component: y of kPairComponent
CAPCON_CONST kPairEnd = 65535u;    // whether it goes on

// Specialisation constants.
CAPCON_CONST kSpecSampler = 0u;      // a sampler id, with kSamplerInParts
CAPCON_CONST kSpecStackSize = 1u;    // entries of the traversal stack beyond its registers, >= 1
CAPCON_CONST kSpecQuadrics = 2u;     // 1: the scene has spheres or disks
CAPCON_CONST kSpecJittered = 3u;     // 1: image samples lie at points of the sampler, 0: at pixel centres
CAPCON_CONST kSpecAnyHit = 4u;       // rays.comp: 1: any hit will do, 0: the closest
CAPCON_CONST kSpecInstances = 5u;    // 1: the scene's tree is one of instances, each with a tree of its own
CAPCON_CONST kSpecDetails = 6u;      // 1: primary.comp writes what shading needs: normal, uv, material
CAPCON_CONST kSpecOrdered = 7u;      // 1: a pixel's samples are taken in the order of kBindOrder
CAPCON_CONST kSpecMaterials = 8u;    // kHas... bits of the scene's materials
CAPCON_CONST kSpecLight = 9u;        // light_samples.comp: the kind of its light
CAPCON_CONST kSpecLightKinds = 10u;  // a bit a kind of the scene's lights
CAPCON_CONST kSpecOctahedral = 11u;  // 1: some environment map is octahedral
CAPCON_CONST kSpecStrategy = 12u;    // kStrategy...
CAPCON_CONST kSpecDetailNormals = 13u;  // 1: details hold the vertices' normals
CAPCON_CONST kSpecDetailUvs = 14u;   // 1: details hold the vertices' uvs
CAPCON_CONST kSpecFilter = 15u;      // 1: image samples are placed by the filter's table, 0: evenly in the pixel
CAPCON_CONST kSpecReceivers = 16u;   // 1: what shades are surfaces that rays met, 0: those that pixels see
CAPCON_CONST kSpecQueue = 17u;       // 1: a subgroup has a queue of rays, and lanes that are done take the next
CAPCON_CONST kSpecGroupSize = 18u;   // lanes of a workgroup of kernels that can have a queue

// Bindings of every kernel; those that a kernel does not name are left out of its layout.
CAPCON_CONST kBindNodes = 0u;       // data texels: four a BVH node
CAPCON_CONST kBindPrimitives = 1u;  // data texels: three a primitive
CAPCON_CONST kBindQuadrics = 2u;    // data texels: seven a sphere or disk
CAPCON_CONST kBindSampler = 3u;     // data texels: the sampler's table
CAPCON_CONST kBindSurfaces = 4u;    // what each pixel sees: two texels (data texels where read, storage where written)
CAPCON_CONST kBindCounts = 5u;      // visible rays a pixel, storage
CAPCON_CONST kBindPoints = 6u;      // sample points as bits, storage (the test kernel's output)
CAPCON_CONST kBindRays = 7u;        // data texels: two a ray (rays.comp)
CAPCON_CONST kBindHits = 8u;        // distance and primitive of each ray, storage (rays.comp)
CAPCON_CONST kBindInstances = 9u;   // data texels: eight an instance
CAPCON_CONST kBindDetails = 10u;    // data texels: what shading needs of a primitive (host/render/geometry.h)
CAPCON_CONST kBindShading = 11u;    // what shading needs of each pixel: two texels, storage
CAPCON_CONST kBindOrder = 12u;     // data texels: the order of a pixel's samples, one word each (occlusion.comp)
CAPCON_CONST kBindMaterials = 13u;  // data texels: materials, texture headers, measured tables (render/material_data.h)
CAPCON_CONST kBindTextures = 14u;   // data texels: a pixel each
CAPCON_CONST kBindLights = 15u;     // data texels: lights and their triangles (render/light_data.h)
CAPCON_CONST kBindEnvironment = 16u;  // data texels: environment maps with their tables
CAPCON_CONST kBindSamples = 17u;    // what each sample of a batch brings, one texel (data texels where read, storage where written)
CAPCON_CONST kBindSums = 18u;       // radiance of each pixel, storage: two texels, the sum and what rounding took from it
CAPCON_CONST kBindFilter = 19u;     // data texels: the filter's quantiles (render/filter_table.h)
CAPCON_CONST kBindVirtualLights = 20u;  // data texels: five a virtual light (shading/virtual_lights.glsl)
CAPCON_CONST kBindPaths = 21u;      // a light path's ray, storage: three texels
CAPCON_CONST kBindPathHits = 22u;   // where light paths hit, storage: five texels, as a virtual light has
CAPCON_CONST kBindFound = 23u;      // surfaces that compensation rays met, storage: six texels (compensation.comp)
CAPCON_CONST kBindQueue = 24u;      // where subgroups' queues of rays go on, storage (tracing/ray_queue.glsl)
CAPCON_CONST kBindCount = 25u;

// Ids in a primitive's first texel (word 3): triangles count from 0, quadrics carry this bit and their index.
CAPCON_CONST kQuadricBit = 0x80000000u;
CAPCON_CONST kNoPrimitive = 0xffffffffu;
// In the root node of an instance: the world's own shapes, which stay as they are.
CAPCON_CONST kWorldInstance = 0x80000000u;
// Quadric kinds, in the first word of the last texel of a quadric.
CAPCON_CONST kQuadricSphere = 0u;
CAPCON_CONST kQuadricDisk = 1u;

// Kinds of materials: bits of kSpecMaterials and first word of a material.
CAPCON_CONST kHasDiffuse = 1u;
CAPCON_CONST kHasConductor = 2u;
CAPCON_CONST kHasAdded = 4u;        // plastics by their coat
CAPCON_CONST kHasSubstrate = 8u;
CAPCON_CONST kHasTransmitted = 16u;
CAPCON_CONST kHasMeasured = 32u;
CAPCON_CONST kHasTexture = 64u;     // some base colour is textured
CAPCON_CONST kWrapRepeat = 0u;
CAPCON_CONST kWrapBlack = 1u;
CAPCON_CONST kWrapClamp = 2u;

// Kinds of lights.
CAPCON_CONST kLightDisk = 0u;
CAPCON_CONST kLightSphere = 1u;
CAPCON_CONST kLightRectangle = 2u;
CAPCON_CONST kLightTriangles = 3u;
CAPCON_CONST kLightMap = 4u;        // environment with an image
CAPCON_CONST kLightConstant = 5u;   // environment without
CAPCON_CONST kLightDistant = 6u;
CAPCON_CONST kLightPoint = 7u;
CAPCON_CONST kLightTwoSided = 1u;   // flags
CAPCON_CONST kLightHidden = 2u;
CAPCON_CONST kLightInward = 4u;

CAPCON_CONST kStrategyPower = 0u;
CAPCON_CONST kStrategyBalance = 1u;
CAPCON_CONST kStrategyOne = 2u;     // light or BSDF samples alone

// Intervals of the filter's table.
CAPCON_CONST kFilterIntervals = 4096u;

// In the light word of a primitive's details, where it is none:
CAPCON_CONST kNoLight = 0x7fffffffu;
// And a bit of it: its triangle emits against the order of its vertices.
CAPCON_CONST kLightTurned = 0x80000000u;

// The tree's place: grid coordinates are (p - origin) * scale.
struct TreeConstants {
  vec4 grid_origin;
  vec4 grid_scale;
};

// 128 bytes, the most that every device takes: the fourth words of the vectors carry counters.
struct PrimaryConstants {
  TreeConstants tree;  // grid_origin.w: unused; grid_scale.w: how far along their directions rays start, 0 for cameras near the scene
  vec4 eye;            // where the ray through film position (0, 0) starts; w: image width in pixels
  vec4 corner;         // direction through film position (0, 0); w: pixels of this batch
  vec4 across;         // change of direction a pixel to the right; w: the band's first pixel
  vec4 down;           // change of direction a pixel downwards; w: 1 if image samples are jittered
  uvec4 words;         // SamplerTables::constants; z: the stride of `count`
  uint seed;
  uint count;
  uint first_pixel;
  uint sample_index;   // jittered: which sample of the pixel
};

struct OcclusionConstants {
  TreeConstants tree;
  uvec4 words;        // SamplerTables::constants
  uint seed;
  uint count;
  uint first_pixel;
  uint pixel_count;   // pixels of this batch
  uint first_sample;  // of the samples first_sample ... first_sample + samples - 1
  uint samples;
  float radius;
  uint group_stride;  // coprime to the number of groups, both below 2^16: spreads the work over the driver's threads
  uint band;          // the first pixel that surfaces and counts are kept for
  uint group_rays;    // with a queue: rays of a workgroup
  uint enough;        // iterations after which no more rays begin
  uint resumed;       // 1: where the dispatch before it ended
};

// points.comp: the points of pixels 0 ... pixel_count - 1, numbered through, from `first` on.
struct PointConstants {
  uvec4 words;        // SamplerTables::constants
  uvec4 split;        // parts, points in a part, and their strides
  uint seed;
  uint pixel_count;
  uint dimension;
  uint domain;
  uint first;
  uint pad0, pad1, pad2;
};

// light_samples.comp and bsdf_samples.comp: 128 bytes.
struct DirectConstants {
  TreeConstants tree;
  uvec4 words;        // SamplerTables::constants
  uvec4 split;        // parts, points in a part, and their strides
  vec4 eye;           // w: the seed's bits
  uint first_pixel;
  uint pixel_count;   // pixels of this batch
  uint first_sample;  // of the samples first_sample ... first_sample + samples - 1 of each
  uint samples;
  uint group_stride;
  uint band;
  uint light;         // light_samples: which; bsdf_samples: how many area lights come before the environments
  uint lights;        // how many there are
  uint flags;         // kDirect...
  float weight;       // light_samples: of each sample; above 1 where one stands for many (point and distant lights)
  uint level;         // of surfaces that rays met: how many such rays it took
  uint pad0;
};
CAPCON_CONST kDirectFirst = 1u;     // the samples' radiance is written, not added to
CAPCON_CONST kDirectSeparate = 2u;  // each part is a set of its own, with dimension numbers of its own
CAPCON_CONST kDirectPlaces = 4u;    // parts belong to image samples at places of their own

// resolve.comp: adds a batch's samples to their pixels.
struct ResolveConstants {
  uint first_pixel;
  uint pixel_count;
  uint samples;       // of each pixel in this batch
  uint band;
  float weight;       // of each
  uint pad0, pad1, pad2;
};

// emission.comp: adds what pixels see of lights themselves.
struct EmissionConstants {
  uint first_pixel;
  uint pixel_count;
  uint band;
  uint light;         // the first environment
  uint lights;
  float weight;       // of this image sample
  uint pad0, pad1;
};

// emit_paths.comp and trace_paths.comp.
struct PathConstants {
  TreeConstants tree;
  uvec4 words;        // SamplerTables::constants
  uvec4 split;        // sets, paths of a set, and their strides
  vec4 bounds;        // the scene's bounding sphere, a little larger; w: its radius
  uint seed;
  uint count;         // paths in all
  uint bounce;
  uint flags;         // kDirectSeparate
  uint lights;
  uint first;         // path of this batch
  uint batch;         // paths of this batch
  uint pad0;
};

// gather.comp
struct GatherConstants {
  TreeConstants tree;
  vec4 eye;           // w: the limit of the geometry term
  uint first_pixel;
  uint pixel_count;   // of the piece whose samples are written
  uint band;
  uint lanes;         // lanes a virtual light, a multiple of kGroupSize
  uint first;         // virtual lights first ... first + count - 1
  uint count;
  uint columns;       // samples of a pixel in this batch; those from `count` on are 0
  uint group_stride;
  uint block;         // above 1: only pixels (residue_x + block i, row + block j), `across` in a row
  uint residue_x;
  uint row;
  uint across;
  uint width;
  uint two_sided;     // 1: virtual lights shine to both sides
  uint pad0, pad1;
};

// compensation.comp
struct CompensationConstants {
  TreeConstants tree;
  uvec4 words;        // SamplerTables::constants
  vec4 eye;           // w: the seed's bits
  uint first_pixel;
  uint pixel_count;
  uint band;
  uint part, parts;   // of the pixel's set
  uint rays;          // of each pixel and part
  uint level;         // 0: from what pixels see
  float limit;
  uint part_stride, ray_stride;
  uint pad0, pad1;
};

struct RayConstants {
  TreeConstants tree;
  uint first;         // ray of this batch
  uint count;         // rays of this batch
  uint group_stride;  // as above
  uint group_rays;    // and these
  uint enough;
  uint resumed;
  uint pad0, pad1;
};

#ifdef __cplusplus
}  // namespace capcon::layout
#endif
#undef CAPCON_CONST
#endif
