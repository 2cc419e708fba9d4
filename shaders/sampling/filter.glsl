// Where in the filter an image sample lies: the inverse of the filter's cumulative distribution, the same for x and y, as a table
// (host/render/filter_table.h): an interval a texel, its first value and the step to the next.
layout(constant_id = kSpecFilter) const uint kFilter = 0u;
DATA_TEXELS(kBindFilter, filter_texels);

float filter_quantile(uint bits) {
  float at = float(bits >> 8u) * (float(kFilterIntervals) * 5.9604644775390625e-8);
  float cell = floor(at);
  uvec2 t = FETCH(filter_texels, uint(cell)).xy;
  return uintBitsToFloat(t.x) + (at - cell) * uintBitsToFloat(t.y);
}

vec2 filter_offset(uvec2 bits) { return vec2(filter_quantile(bits.x), filter_quantile(bits.y)); }
