// A ray, and its form in the tree's grid.
struct Ray {
  vec3 origin;
  vec3 direction;  // unit length
  float t_max;
  uint skip;       // a primitive that is not tested (the one it starts on), or kNoPrimitive
};

// Low planes are tested as (plane - near) * inverse, high planes as (plane - far) * inverse: near and far differ by the
// rounding error of the origin's place in the grid, so that no box is missed from however far away, for either sign of the
// direction.
struct GridRay {
  vec3 near;
  vec3 far;
  vec3 inverse;
};

// `error`: of the origin and the grid's, in units of the ray's space.
GridRay to_grid(Ray ray, vec3 grid_origin, vec3 grid_scale, vec3 error) {
  GridRay g;
  vec3 origin = (ray.origin - grid_origin) * grid_scale;
  vec3 direction = ray.direction * grid_scale;
  vec3 magnitude = max(abs(direction), vec3(1e-18));  // keeps inverse * 65536 finite, and no 0 * infinity
  g.inverse = mix(1.0 / magnitude, -1.0 / magnitude, lessThan(direction, vec3(0.0)));
  g.near = origin + error * grid_scale;
  g.far = origin - error * grid_scale;
  return g;
}
