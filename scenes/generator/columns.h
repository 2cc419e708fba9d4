#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// A fluted column with attic base, entasis and a moulded capital; stands on z = 0, its abacus ends at
/// `height`.
Mesh fluted_column(double height, double radius);

/// A smooth slender column for a gallery, on z = 0 up to `height`.
Mesh slender_column(double height, double radius);

/// A turned baluster on z = 0 up to `height`.
Mesh baluster(double height);

/// A square pier with plinth and impost, on z = 0 up to `height`.
Mesh square_pier(double height, double half_width);

}  // namespace capcon::scenes
