// GGX (Walter et al., EGSR 2007) in a local frame, z the normal. Sines come from x and y: 1 - z^2 would lose small roughness.

float ggx(vec3 h, float alpha) {
  float a2 = alpha * alpha;
  float t = h.x * h.x + h.y * h.y + h.z * h.z * a2;
  return h.z > 0.0 ? a2 / (3.14159265358979 * t * t) : 0.0;
}

// Smith's masking for one direction.
float ggx_masking(vec3 w, float alpha) {
  float tangent2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
  return 2.0 / (1.0 + sqrt(1.0 + alpha * alpha * tangent2));
}

// A normal that is visible from `o` (Heitz, JCGT 7(4), 2018), the disk by the concentric map.
vec3 visible_normal(vec3 o, float alpha, vec2 u) {
  vec3 v = normalize(vec3(alpha * o.xy, o.z));
  vec3 t1 = v.z > 0.99999 ? vec3(1.0, 0.0, 0.0) : vec3(-v.y, v.x, 0.0) / sqrt(max(v.x * v.x + v.y * v.y, 1e-30));
  vec3 t2 = cross(v, t1);
  vec2 t = concentric_disk(u);
  float k = 0.5 * (1.0 + v.z);
  t.y = (1.0 - k) * sqrt(max(0.0, 1.0 - t.x * t.x)) + k * t.y;
  vec3 n = t.x * t1 + t.y * t2 + sqrt(max(0.0, 1.0 - dot(t, t))) * v;
  return normalize(vec3(alpha * n.xy, max(1e-6, n.z)));
}

// Unpolarised reflectance (Born and Wolf, section 14.2). The root a of a + ib = sqrt((eta + ik)^2 - sin^2) is taken where
// nothing cancels.
float fresnel(float cosine, float eta, float k) {
  float c = clamp(cosine, 0.0, 1.0), c2 = c * c, s2 = 1.0 - c2;
  float re = eta * eta - k * k - s2, im = 2.0 * eta * k;
  float modulus = sqrt(re * re + im * im);
  float larger = sqrt(0.5 * (modulus + abs(re)));
  float a = re >= 0.0 ? larger : abs(im) / (2.0 * max(larger, 1e-30));
  float perpendicular = (modulus - 2.0 * a * c + c2) / max(modulus + 2.0 * a * c + c2, 1e-30);
  float t = c2 * modulus + s2 * s2, v = 2.0 * a * c * s2;
  float ratio = t + v > 0.0 ? (t - v) / (t + v) : 1.0;
  return 0.5 * (perpendicular + perpendicular * ratio);
}

float luminance(vec3 rgb) { return dot(rgb, vec3(0.2126729, 0.7151522, 0.0721750)); }
