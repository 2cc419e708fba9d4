// A ray, and its form in the tree's grid.
struct Ray {
  vec3 origin;
  vec3 direction;  // unit length
  float t_max;
  uint skip;       // a primitive that is not tested (the one it starts on), or kNoPrimitive
};

// Planes are tested as (plane - near) * inverse for the planes that the ray meets first, far for the others; near and far
// differ by the rounding error of the origin's place in the grid, so that no box is missed from however far away.
struct GridRay {
  vec3 near;
  vec3 far;
  vec3 inverse;
  uvec3 shift;  // 0 where the direction is positive: the low half of a plane pair is met first; else 16
};

GridRay to_grid(Ray ray, TreeConstants tree) {
  GridRay g;
  vec3 origin = (ray.origin - tree.grid_origin.xyz) * tree.grid_scale.xyz;
  // Subtraction and product round by 2^-24 each of the larger operand.
  vec3 error = (abs(ray.origin) + abs(tree.grid_origin.xyz)) * tree.grid_scale.xyz * 1.8e-7;
  vec3 direction = ray.direction * tree.grid_scale.xyz;
  vec3 magnitude = max(abs(direction), vec3(1e-18));  // keeps inverse * 65536 finite, and no 0 * infinity
  bvec3 negative = lessThan(direction, vec3(0.0));
  g.inverse = mix(1.0 / magnitude, -1.0 / magnitude, negative);
  vec3 sign_error = mix(error, -error, negative);
  g.near = origin + sign_error;
  g.far = origin - sign_error;
  g.shift = mix(uvec3(0u), uvec3(16u), negative);
  return g;
}
