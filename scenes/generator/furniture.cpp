#include "generator/courtyard.h"

namespace capcon::scenes::court {
void add_furniture(Assembly&) {}
}  // namespace capcon::scenes::court
