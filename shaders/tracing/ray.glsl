// A ray, and its form in the tree's grid.
struct Ray {
  vec3 origin;
  vec3 direction;  // unit length
  float t_max;
  uint skip;       // a primitive that is not tested (the one it starts on), or kNoPrimitive
#ifdef RAYS_TO_LIGHTS
  uint light;      // nor are the primitives of the light that it goes to: this one and so many after it
  uint more_lights;
#endif
};

// Whether a primitive counts for a ray.
bool counts(Ray ray, uint id) {
#ifdef RAYS_TO_LIGHTS
  return id != ray.skip && id - ray.light > ray.more_lights;
#else
  return id != ray.skip;
#endif
}

// A box is met on an axis where (centre - origin) * inverse is within half extent * stretch of 0 or more. Coordinates are the
// grid's, from its middle, for the centre in units of 1/65536, as the nodes' words have it.
struct GridRay {
  vec3 origin;
  vec3 inverse;
  vec3 stretch;  // |inverse| of grid coordinates
  vec3 slack;    // two levels: what half extents grow by for the rounding of the origin
};

// `error`: of the origin and the grid's, in units of the ray's space. Boxes are a quarter of a cell larger than they hold: what
// goes beyond that is covered by slack, or, with one level, where only cameras far outside the scene need it, by boxes that are
// larger by a factor; half extents are 1 or more.
GridRay to_grid(Ray ray, vec3 grid_origin, vec3 grid_scale, vec3 error, bool slack) {
  GridRay g;
  vec3 direction = ray.direction * grid_scale;
  vec3 inverse = 1.0 / max(abs(direction), vec3(1e-18));  // keeps inverse * 65536 finite, and no 0 * infinity
  vec3 beyond = max(error * grid_scale - 0.25, vec3(0.0));
  g.origin = ((ray.origin - grid_origin) * grid_scale - 32768.0) * 65536.0;
  g.inverse = mix(inverse, -inverse, lessThan(direction, vec3(0.0))) * (1.0 / 65536.0);
  g.stretch = slack ? inverse : inverse * (1.0 + beyond);
  g.slack = beyond;
  return g;
}
