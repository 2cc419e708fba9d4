// How samples of two densities share what both can find (Veach and Guibas 1995), as ratios, which do not overflow.
layout(constant_id = kSpecStrategy) const uint kStrategy = kStrategyPower;

float mis_weight(float own, float other) {
  float r = other / own;
  return kStrategy == kStrategyPower ? 1.0 / (1.0 + r * r) : (kStrategy == kStrategyBalance ? 1.0 / (1.0 + r) : 1.0);
}
