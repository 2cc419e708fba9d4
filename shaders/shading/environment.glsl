// Environment maps (host/shading/environment.h, host/render/light_data.h): at `base` two header texels (places of rows, row guide,
// columns, column guides; of pixels, width, height), then rows of (sum, depth below the pole at the top edge, density of a unit of a
// column, depth at the bottom edge), packed words of sums and guides, and a texel a pixel.
DATA_TEXELS(kBindEnvironment, environment_texels);
layout(constant_id = kSpecOctahedral) const uint kOctahedral = 0u;  // 1: some are octahedral

struct Map {
  uvec4 places;
  uvec4 size;  // pixels' place, width, height, 1: octahedral
};

Map load_map(uint base) {
  return Map(FETCH(environment_texels, base), FETCH(environment_texels, base + 1u));
}

uint map_word(uint place, uint i) {
  uvec4 t = FETCH(environment_texels, place + (i >> 2u));
  uint c = i & 3u;
  return c < 2u ? (c == 0u ? t.x : t.y) : (c == 2u ? t.z : t.w);
}

uint row_sum(Map m, uint y) { return FETCH(environment_texels, m.places.x + y).x; }
uint column_sum(Map m, uint y, uint x) { return map_word(m.places.z, y * (m.size.y + 1u) + x); }

uint guide_size(uint cells) { return (cells + 3u) >> 2u; }

// The cell that holds `value` (24 bits): the first whose upper sum is above it, between those that the guide names.
uint search(Map m, bool rows, uint y, uint low, uint high, uint value) {
  bool going = low < high;
  while (going) {
    uint middle = (low + high) >> 1u;
    uint sum = rows ? row_sum(m, middle + 1u) : column_sum(m, y, middle + 1u);
    bool above = sum > value;
    high = going && above ? middle : high;
    low = going && !above ? middle + 1u : low;
    going = low < high;
  }
  return low;
}

uint part_of(uint bits, uint parts) {
  uint high, low;
  umulExtended(bits & 0xffffff00u, parts, high, low);
  return high;
}

vec3 octahedral_direction(vec2 square) {
  vec2 p = 2.0 * square - 1.0;
  vec2 a = abs(p);
  float depth = 1.0 - a.x - a.y;
  float r = 1.0 - abs(depth);
  float turn = r == 0.0 ? 0.0 : (a.y - a.x) / r;  // from the quadrant's diagonal, -1 to 1
  vec2 cs = cos_sin_octant(turn * 0.785398163397448);
  vec2 direction = vec2(cs.x - cs.y, cs.x + cs.y) * 0.7071067811865476;  // turned by an eighth
  float ring = r * sqrt(max(0.0, 2.0 - r * r));
  float z = 1.0 - r * r;
  return vec3(ring * direction.x * (p.x < 0.0 ? -1.0 : 1.0), ring * direction.y * (p.y < 0.0 ? -1.0 : 1.0), depth < 0.0 ? -z : z);
}

vec2 octahedral_square(vec3 d) {
  vec3 a = abs(d);
  float r = sqrt(max(0.0, (d.x * d.x + d.y * d.y) / (1.0 + a.z)));  // sqrt(1 - |z|) without cancellation
  float v = angle_in_quadrant(a.y, a.x) * 0.6366197723675814 * r;
  vec2 p = vec2(r - v, v);
  p = d.z < 0.0 ? vec2(1.0 - p.y, 1.0 - p.x) : p;
  return 0.5 * (vec2(d.x < 0.0 ? -p.x : p.x, d.y < 0.0 ? -p.y : p.y) + 1.0);
}

vec2 map_square(Map m, vec3 d) {
  vec2 s = vec2(turn_of(d.y, d.x), 0.0);
  float theta = angle_in_quadrant(sqrt(d.x * d.x + d.y * d.y), abs(d.z)) * 0.3183098861837907;
  s.y = d.z < 0.0 ? 1.0 - theta : theta;
  if (kOctahedral != 0u) s = m.size.w != 0u ? octahedral_square(d) : s;
  return s;
}

// A direction in the map's space, and its density per solid angle in w.
vec4 sample_map(Map m, uvec2 bits) {
  uint width = m.size.y, height = m.size.z;
  uvec2 value = bits >> 8u;
  uint part = part_of(bits.y, guide_size(height));
  uint y = search(m, true, 0u, map_word(m.places.y, part), min(map_word(m.places.y, part + 1u), height - 1u), value.y);
  uvec4 row = FETCH(environment_texels, m.places.x + y);
  float within_row = float(value.y - row.x) / float(max(row_sum(m, y + 1u) - row.x, 1u));
  uint guides = guide_size(width);
  part = part_of(bits.x, guides);
  uint first = y * (guides + 1u) + part;
  uint x = search(m, false, y, map_word(m.places.w, first), min(map_word(m.places.w, first + 1u), width - 1u), value.x);
  uint left = column_sum(m, y, x);
  uint units = max(column_sum(m, y, x + 1u) - left, 1u);
  float u = (float(x) + float(value.x - left) / float(units)) / float(width);
  float depth = mix(uintBitsToFloat(row.y), uintBitsToFloat(row.w), within_row);
  float ring = sqrt(max(0.0, depth * (2.0 - depth)));
  vec3 d = vec3(ring * cos_sin_turn(u), 2u * y < height ? 1.0 - depth : depth - 1.0);
  if (kOctahedral != 0u) d = m.size.w != 0u ? octahedral_direction(vec2(u, (float(y) + within_row) / float(height))) : d;
  return vec4(d, uintBitsToFloat(row.z) * float(units));
}

float map_pdf(Map m, vec2 square) {
  uint x = min(uint(square.x * float(m.size.y)), m.size.y - 1u);
  uint y = min(uint(square.y * float(m.size.z)), m.size.z - 1u);
  float density = uintBitsToFloat(FETCH(environment_texels, m.places.x + y).z);
  return density * float(column_sum(m, y, x + 1u) - column_sum(m, y, x));
}

vec3 map_pixel(Map m, ivec2 p) {
  ivec2 size = ivec2(m.size.yz);
  ivec2 q = ivec2(p.x < 0 ? p.x + size.x : (p.x >= size.x ? p.x - size.x : p.x), clamp(p.y, 0, size.y - 1));
  if (kOctahedral != 0u) {
    // An edge is folded at its middle.
    ivec2 o = p;
    bool beside = o.x < 0 || o.x >= size.x;
    o = beside ? ivec2(o.x < 0 ? -1 - o.x : 2 * size.x - 1 - o.x, size.y - 1 - o.y) : o;
    bool above = o.y < 0 || o.y >= size.y;
    o = above ? ivec2(size.x - 1 - o.x, o.y < 0 ? -1 - o.y : 2 * size.y - 1 - o.y) : o;
    q = m.size.w != 0u ? clamp(o, ivec2(0), size - 1) : q;
  }
  return uintBitsToFloat(FETCH(environment_texels, m.size.x + uint(q.y) * m.size.y + uint(q.x)).xyz);
}

// Bilinear between texel centres.
vec3 map_value(Map m, vec2 square) {
  vec2 at = square * vec2(m.size.yz) - 0.5;
  vec2 corner = floor(at);
  vec2 t = at - corner;
  ivec2 p = ivec2(corner);
  vec3 lower = mix(map_pixel(m, p), map_pixel(m, p + ivec2(1, 0)), t.x);
  vec3 upper = mix(map_pixel(m, p + ivec2(0, 1)), map_pixel(m, p + ivec2(1, 1)), t.x);
  return mix(lower, upper, t.y);
}
