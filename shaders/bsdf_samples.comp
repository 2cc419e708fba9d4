#version 460
#extension GL_GOOGLE_include_directive : require
// Direct lighting by the BSDF's points (docs/direct.md): one ray a thread for all lights. Lights that are no meshes are met one by
// one, so that a ray is cast only where there is light to block; with mesh lights it is the scene's nearest surface. Reads what
// pixels see, materials, lights, the tree and the sampler's table; writes or adds to one texel a sample.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
#include "shading/direct.glsl"
#include "tracing/details.glsl"

struct Met {
  float t;      // 3e38: no area light
  uint light;
  vec3 radiance;
  float pdf;
};

// The nearest area light on a ray, whatever lies before it.
Met nearest_light(Ray ray) {
  Met met = Met(3e38, kNoLight, vec3(0.0), 0.0);
  for (uint k = 0u; k < push.light; ++k) {
    Light l = load_light(k);
    vec3 radiance;
    float pdf;
    float t = meet_light(l, ray, radiance, pdf);
    bool own = ray.skip - l.first_primitive <= l.more_primitives;
    bool nearer = t > 0.0 && t < met.t && !own && (l.flags & kLightHidden) == 0u;
    met.t = nearer ? t : met.t;
    met.light = nearer ? k : met.light;
    met.radiance = nearer ? radiance : met.radiance;
    met.pdf = nearer ? pdf : met.pdf;
  }
  return met;
}

// The light, if any, whose surface a ray meets first.
Met surface_light(Ray ray, Hit hit) {
  uint slot = hit.slot == kNoPrimitive ? 0u : hit.slot;
  uint word = load_details(slot, hit.weights).light;
  uvec4 w0 = FETCH(primitive_texels, slot * 3u);
  vec3 p0 = uintBitsToFloat(w0.xyz);
  vec3 p1 = uintBitsToFloat(FETCH(primitive_texels, slot * 3u + 1u).xyz);
  vec3 p2 = uintBitsToFloat(FETCH(primitive_texels, slot * 3u + 2u).xyz);
  vec3 normal = cross(p1 - p0, p2 - p0);
  bool quadric = kHasQuadrics != 0u && (w0.w & kQuadricBit) != 0u;
  if (kHasQuadrics != 0u) {
    uint q = quadric ? w0.w & ~kQuadricBit : 0u;
    vec3 o = quadric_point(q, 0u, ray.origin + hit.t * ray.direction);
    vec3 n = FETCH(quadric_texels, q * 7u + 6u).x == kQuadricDisk ? vec3(0.0, 0.0, 1.0) : o;
    vec3 world = quadric_row(q, 0u).xyz * n.x + quadric_row(q, 1u).xyz * n.y + quadric_row(q, 2u).xyz * n.z;
    normal = quadric ? world : normal;
  }
  uint index = word & ~kLightTurned;
  bool none = hit.slot == kNoPrimitive || index == kNoLight;
  Light l = load_light(none ? 0u : index);
  float cosine = dot(normalize(normal), ray.direction);
  bool front = (cosine < 0.0) != ((word & kLightTurned) != 0u);
  float pdf = hit.t * hit.t / (l.area * max(abs(cosine), 1e-30));
  if (has_light(kLightSphere)) {
    vec3 d = l.position - ray.origin;
    float d2 = dot(d, d);
    pdf = l.kind == kLightSphere && d2 > l.radius * l.radius ? 1.0 / (6.283185307179586 * cone_depth(l.radius, d2)) : pdf;
  }
  return Met(hit.t, none ? kNoLight : index, none || !shines(l, front) ? vec3(0.0) : l.radiance, none ? 0.0 : pdf);
}

void main() {
  Job job = this_job();
  Surface s = load_surface(job.pixel - push.band, push.eye.xyz, job.live);
  job = addressed(job, s);
  Bsdf bsdf = load_bsdf(s.material, s.uv, from_frame(s.wo, s.ns));
  vec2 u = unit_floats(bsdf_point(job));
  float choice = has(kMicrofacets) ? choice_of(job) : 0.0;
  vec3 i = sample_bsdf(bsdf, u, choice);
  vec3 w = normalize(to_frame(i, s.ns));
  bool lit = s.live && i.z > 0.0 && bsdf.o.z > 0.0 && dot(w, s.ng) > 0.0;
  i = lit ? i : vec3(0.0, 0.0, 1.0);
  vec4 f = evaluate_bsdf(bsdf, i);
  lit = lit && f.w > 0.0 && max(max(f.x, f.y), f.z) > 0.0;

  Ray ray;
  ray.origin = s.origin;
  ray.direction = w;
  ray.t_max = 3e38;
  ray.skip = s.primitive;
  ray.light = kNoPrimitive;
  ray.more_lights = 0u;
  bool sky = push.lights > push.light && (has_light(kLightMap) || has_light(kLightConstant));
  Met met;
  bool visible;
  if (has_light(kLightTriangles)) {
    Hit hit = closest(ray, push.tree, lit);
    met = surface_light(ray, hit);
    visible = lit && (hit.slot == kNoPrimitive || met.light != kNoLight);
  } else {
    met = nearest_light(ray);
    bool found = met.light != kNoLight;
    Light l = load_light(found ? met.light : 0u);
    ray.light = found ? l.first_primitive : kNoPrimitive;
    ray.more_lights = found ? l.more_primitives : 0u;
    ray.t_max = found ? met.t * kShort : 3e38;
    bool worth = lit && (found ? max(max(met.radiance.x, met.radiance.y), met.radiance.z) > 0.0 : sky);
    visible = !occluded(ray, push.tree, worth) && worth;
  }
  vec3 light = vec3(0.0);
  if (met.light != kNoLight) {
    light = met.radiance * mis_weight(f.w, met.pdf);
  } else if (sky) {
    for (uint k = push.light; k < push.lights; ++k) {
      Light l = load_light(k);
      float pdf;
      vec3 radiance = environment_towards(l, w, s.ng, pdf);
      bool environment = l.kind == kLightMap || l.kind == kLightConstant;
      light += environment ? radiance * mis_weight(f.w, pdf) : vec3(0.0);
    }
  }
  write_sample(job, visible ? f.xyz * (i.z / f.w) * light : vec3(0.0));
}
