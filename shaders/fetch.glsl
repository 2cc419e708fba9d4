// How kernels read trees, primitives and tables: 16-byte texels. On lavapipe a storage buffer load is a scalar loop over
// lanes and an image load an inlined gather, fifteen times faster; hardware prefers storage buffers. Same bits either way.
#ifdef FETCH_TEXEL
#define DATA_TEXELS(bind, name) layout(set = 0, binding = bind, rgba32ui) uniform readonly uimageBuffer name
#define FETCH(name, i) imageLoad(name, int(i))
#else
#define DATA_TEXELS(bind, name) \
  layout(set = 0, binding = bind, std430) readonly buffer name##Block { uvec4 name[]; }
#define FETCH(name, i) name[i]
#endif
