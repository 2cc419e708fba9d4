#pragma once

#include "reference/primitives.h"

namespace capcon::reference {

// Rays here are in object space and need not have unit length: t counts in lengths of the direction. Both
// return the first t in (0, t_max], or a negative number.

/// The full sphere about the origin.
double intersect_sphere(const Ray& ray, double radius, double t_max);

/// The ring inner_radius <= r <= radius in the plane z = height.
double intersect_disk(const Ray& ray, double height, double inner_radius, double radius, double t_max);

}  // namespace capcon::reference
