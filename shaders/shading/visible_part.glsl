// Rays that end on a light stop short of it, so that what it is flush with does not hide it.
const float kShort = 0.99999237060546875;  // 1 - 2^-17
