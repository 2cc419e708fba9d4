#pragma once

#include <functional>

#include "generator/mesh.h"

namespace capcon::scenes {

/// Height of a pointed arch above its springing; s from 0 (springing) to 1 (crown), `half` is half its span.
double pointed_height(double s, double half);

/// A quadripartite vault over [0, length] x [-half_width, half_width], springing at z = 0; two pointed
/// barrels of one height that meet in groins. It faces down. `half` sets the height: pointed_height(1, half).
Mesh groin_vault(double length, double half_width, double half, int segments);

/// One gore of a vault over an apse: between a wall from `a` to `b` and the key over `centre`, in plan,
/// springing at z = 0.
Mesh apse_gore(const Vec2& a, const Vec2& b, const Vec2& centre, double half, int segments);

/// A rib under the vault along a straight line in plan from a to b; height(t), t from 0 to 1, gives its
/// curve.
Mesh rib(const Vec2& a, const Vec2& b, const std::function<double(double)>& height, double width,
         double depth, int segments);

/// The boss where ribs meet, a pendant with a flower's outline, about the origin.
Mesh vault_boss(double radius);

}  // namespace capcon::scenes
