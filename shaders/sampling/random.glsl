// Independent uniform points.
uvec2 sample_random(uint seed, uint pixel, uint index, uint dimension) {
  return pcg4d(uvec4(pixel, index, dimension, seed)).xy;
}
