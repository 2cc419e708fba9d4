#include "integrate/integrand.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"

namespace capcon::integrate {

const std::vector<Integrand>& battery() {
  static const std::vector<Integrand> all = [] {
    std::vector<Integrand> list;
    for (auto part : {smooth_integrands(), edge_integrands(), disk_integrands()}) {
      for (Integrand& integrand : part) list.push_back(std::move(integrand));
    }
    return list;
  }();
  return all;
}

const Integrand& find_integrand(std::string_view name) {
  std::vector<std::string> names;
  for (const Integrand& integrand : battery()) {
    if (integrand.name == name) return integrand;
    names.push_back(integrand.name);
  }
  throw InputError(fmt::format("there is no integrand \"{}\"; choose of: {}", name, fmt::join(names, " ")));
}

}  // namespace capcon::integrate
