#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace capcon {

/// A hash of all geometry, transforms and the camera: two scenes of equal fingerprint give the same images.
std::uint64_t fingerprint(const Scene& scene);

/// A hash of points of every sampler: a changed tile set or scrambling changes it, so old measurements are
/// not mixed in.
std::uint64_t points_fingerprint();

/// Length of the diagonal of the box around everything in world space (spheres and disks by their bounding
/// boxes) but area lights, which may hang far away.
double diagonal(const Scene& scene);

/// The radius of a study that was told none: a twentieth of the diagonal, to two digits.
double default_radius(const Scene& scene);

/// Sets the film to `width` x `height`; a zero follows from the other and the film's own shape, both zero
/// from `pixels` in all.
void set_film(Scene& scene, int width, int height, double pixels);

}  // namespace capcon
