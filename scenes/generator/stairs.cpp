#include "generator/courtyard.h"

namespace capcon::scenes::court {
void add_stairs(Assembly&) {}
}  // namespace capcon::scenes::court
