#include "generator/courtyard.h"

namespace capcon::scenes::court {
void add_plants(Assembly&) {}
}  // namespace capcon::scenes::court
