#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// A leaf of four triangles, folded along its middle and hanging a little towards its tip. `direction` and
/// `up` need not be unit or orthogonal.
void add_leaf(Mesh& mesh, const Vec3& base, const Vec3& direction, const Vec3& up, double length,
              double width);

/// A small round tree with fruits: trunk, boughs and some thousand leaves; its foot is the origin, `height`
/// about 3. Materials bark, leaf, fruit.
Model orange_tree(double height, int leaves, std::uint64_t stream);

/// A round shrub on the origin. Materials bark, leaf.
Model shrub(double radius, int leaves, std::uint64_t stream);

/// Stems with flowers, as in a flower pot. Materials leaf, flower.
Model geranium(std::uint64_t stream);

/// A rosette of long stiff blades. Material leaf.
Model agave(double size, int blades, std::uint64_t stream);

/// A plant that climbs a wall at y = 0 (facing -y) from the origin, up to `height`. Materials bark, ivy.
Model climber(double width, double height, int leaves, std::uint64_t stream);

/// Shoots with leaves that lie over a horizontal frame, x and y from 0 to `size`, about z = 0. Materials ivy,
/// flower.
Model canopy(double size, int leaves, std::uint64_t stream);

/// A tall flame of foliage, `height` high. Materials bark, leaf.
Model cypress(double height, int leaves, std::uint64_t stream);

}  // namespace capcon::scenes
