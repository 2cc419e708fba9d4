#version 460
#extension GL_GOOGLE_include_directive : require
// Direct lighting by the points of one light (docs/direct.md): one shadow ray a thread. Reads what pixels see, materials, the light,
// the tree and the sampler's table; writes or adds to one texel a sample.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(constant_id = kSpecLight) const uint kLight = kLightDisk;
#include "shading/direct.glsl"

void main() {
  Job job = this_job();
  Surface s = load_surface(job.pixel - push.band, push.eye.xyz, job.live);
  job = addressed(job, s);
  Light light = load_light(push.light);
  bool disk = kLight == kLightDisk || kLight == kLightConstant;
  bool sphere = kLight == kLightSphere;
  vec3 to_centre = light.position - s.origin;
  bool around = sphere && dot(to_centre, to_centre) > light.radius * light.radius;
  bool round_about = (sphere && !around) || kLight == kLightMap;
  uint domain = disk || around ? kDomainDisk : (round_about ? kDomainCylinder : kDomainSquare);
  bool alone = kLight == kLightDistant || kLight == kLightPoint;
  uvec2 bits = alone ? uvec2(0u) : light_point(job, kPairLights + push.light, domain);
  LightSample l = sample_light(kLight, light, s.origin, s.ng, bits);

  Bsdf bsdf = load_bsdf(s.material, s.uv, from_frame(s.wo, s.ns));
  vec3 i = from_frame(l.w, s.ns);
  bool lit = s.live && l.pdf > 0.0 && i.z > 0.0 && bsdf.o.z > 0.0 && dot(l.w, s.ng) > 0.0 &&
             max(max(l.radiance.x, l.radiance.y), l.radiance.z) > 0.0;
  i = lit ? i : vec3(0.0, 0.0, 1.0);
  vec4 f = evaluate_bsdf(bsdf, i);
  float weight = push.weight * (alone || (light.flags & kLightHidden) != 0u ? 1.0 : mis_weight(l.pdf, f.w));

  Ray ray;
  ray.origin = s.origin;
  ray.direction = l.w;
  ray.t_max = l.t < 1e38 ? l.t * kShort : 3e38;
  ray.skip = s.primitive;
  ray.light = l.primitive;
  ray.more_lights = l.more_primitives;
  vec3 radiance = f.xyz * (i.z * weight / (lit ? l.pdf : 1.0)) * l.radiance;
  lit = lit && max(max(radiance.x, radiance.y), radiance.z) > 0.0;
  bool visible = !occluded(ray, push.tree, lit) && lit;
  write_sample(job, visible ? radiance : vec3(0.0));
}
