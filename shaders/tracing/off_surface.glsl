// Off a surface by the bound of the position's error, and outwards by the rounding of that sum.
vec3 off_surface(vec3 position, vec3 normal, vec3 error) {
  vec3 offset = dot(abs(normal), error) * normal;
  vec3 origin = position + offset;
  return origin + sign(offset) * abs(origin) * 1.2e-7;
}
