// BSDFs (docs/direct.md): five texels a material (host/render/material_data.h). kSpecMaterials says which kinds the scene has; the others are compiled out.
layout(constant_id = kSpecMaterials) const uint kMaterials = 1u;
DATA_TEXELS(kBindMaterials, material_texels);

#include "shading/microfacet.glsl"
#include "shading/measured.glsl"
#include "shading/texture.glsl"

const float kInvPi = 0.3183098861837907;
bool has(uint kinds) { return (kMaterials & kinds) != 0u; }
const uint kMicrofacets = kHasConductor | kHasAdded | kHasSubstrate | kHasTransmitted | kHasMeasured;
const uint kPlastics = kHasAdded | kHasSubstrate | kHasTransmitted;

// A material at a point, seen from `o`, in the frame of the shading normal.
struct Bsdf {
  uint kind;    // one bit of kHas...
  vec3 o;
  vec3 base;
  vec3 specular;
  vec3 eta;
  vec3 k;
  float alpha;
  float chance;  // of sampling visible normals instead of the cosine
  float inner;   // coat `transmitted`: inner reflectance
  uint table;    // measured
};

vec3 schlick(vec3 f0, float cosine) {
  float m = 1.0 - clamp(cosine, 0.0, 1.0), m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

Bsdf load_bsdf(uint material, vec2 uv, vec3 o) {
  uint at = material * 5u;
  uvec4 w0 = FETCH(material_texels, at);
  Bsdf b;
  b.kind = w0.x & ~kHasTexture;
  b.o = o;
  b.base = uintBitsToFloat(FETCH(material_texels, at + 1u).xyz);
  if (has(kHasTexture)) {
    vec3 value = texture_value(w0.z, uv);
    b.base = (w0.x & kHasTexture) != 0u ? value : b.base;
  }
  b.chance = 0.0;
  if (has(kMicrofacets)) {
    vec4 w2 = uintBitsToFloat(FETCH(material_texels, at + 2u));
    vec4 w3 = uintBitsToFloat(FETCH(material_texels, at + 3u));
    b.specular = w2.xyz;
    b.eta = w3.xyz;
    b.inner = w3.w;
    b.k = uintBitsToFloat(FETCH(material_texels, at + 4u).xyz);
    b.alpha = uintBitsToFloat(w0.y);
    b.table = w0.w;
    b.chance = w2.w;  // measured: the fitted weight; conductor: 1; diffuse: 0
  }
  if (has(kPlastics)) {
    bool substrate = has(kHasSubstrate) && b.kind == kHasSubstrate;
    vec3 f0 = schlick(b.specular, o.z);
    float f = substrate ? luminance(f0) : fresnel(o.z, b.eta.x, 0.0);
    float s = substrate ? f : luminance(b.specular) * f;
    float d = substrate ? luminance(b.base * (1.0 - f0)) : luminance(b.base) * (1.0 - f);
    bool plastic = (b.kind & kPlastics) != 0u;
    b.chance = plastic ? (s + d > 0.0 ? s / (s + d) : 0.0) : b.chance;
  }
  return b;
}

// f in xyz and the density of sampling `i` in w; both above the horizon.
vec4 evaluate_bsdf(Bsdf b, vec3 i) {
  vec3 f = b.base * kInvPi;
  float cosine_pdf = i.z * kInvPi;
  if (!has(kMicrofacets)) return vec4(f, cosine_pdf);
  vec3 h = normalize(i + b.o);
  float oh = dot(b.o, h);
  float mask = ggx_masking(b.o, b.alpha);
  float d = ggx(h, b.alpha);
  float normals_pdf = d * mask / (4.0 * b.o.z);
  float facets = d * mask * ggx_masking(i, b.alpha) / (4.0 * i.z * b.o.z);
  if (has(kHasConductor)) {
    vec3 r = vec3(fresnel(oh, b.eta.x, b.k.x), fresnel(oh, b.eta.y, b.k.y), fresnel(oh, b.eta.z, b.k.z));
    f = b.kind == kHasConductor ? b.specular * r * facets : f;
  }
  if (has(kHasAdded | kHasTransmitted)) {
    vec3 coat = b.specular * fresnel(oh, b.eta.x, 0.0) * facets;
    if (has(kHasAdded)) f = b.kind == kHasAdded ? b.base * kInvPi + coat : f;
    if (has(kHasTransmitted)) {
      float through = (1.0 - fresnel(i.z, b.eta.x, 0.0)) * (1.0 - fresnel(b.o.z, b.eta.x, 0.0)) / (b.eta.x * b.eta.x);
      f = b.kind == kHasTransmitted ? b.base * kInvPi * through / (1.0 - b.base * b.inner) + coat : f;
    }
  }
  if (has(kHasSubstrate)) {
    float mi = 1.0 - 0.5 * i.z, mo = 1.0 - 0.5 * b.o.z;
    float mi2 = mi * mi, mo2 = mo * mo;
    float under = 28.0 / 23.0 * kInvPi * (1.0 - mi2 * mi2 * mi) * (1.0 - mo2 * mo2 * mo);
    f = b.kind == kHasSubstrate ? b.base * (1.0 - b.specular) * under + schlick(b.specular, oh) * facets : f;
  }
  if (has(kHasMeasured)) {
    if (b.kind == kHasMeasured) f = measured_value(b.table, i, b.o);
  }
  return vec4(f, mix(cosine_pdf, normals_pdf, b.chance));
}

// A direction, by the point of dimension pair 0 and the choice of a component; it may be below the horizon.
vec3 sample_bsdf(Bsdf b, vec2 u, float choice) {
  vec3 i = cosine_hemisphere(u);
  if (has(kMicrofacets)) {
    vec3 h = visible_normal(b.o, b.alpha, u);
    vec3 mirrored = 2.0 * dot(b.o, h) * h - b.o;
    i = choice < b.chance ? mirrored : i;
  }
  return i;
}
