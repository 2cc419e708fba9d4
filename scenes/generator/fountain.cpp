#include "generator/courtyard.h"

namespace capcon::scenes::court {
void add_fountain(Assembly&) {}
}  // namespace capcon::scenes::court
