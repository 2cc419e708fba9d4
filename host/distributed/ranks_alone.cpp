#ifndef CAPCON_MPI
#include <cstdlib>

#include "base/error.h"
#include "distributed/launcher.h"
#include "distributed/ranks.h"

namespace capcon {

// What a program that was built without MPI has: one rank.

bool built_with_mpi() {
  return false;
}

Ranks::Ranks() {
  if (launched_together()) {
    throw Failure(
        "this capcon was built without MPI, and several processes were started together; install "
        "libopenmpi-dev, "
        "run cmake again and build it");
  }
}

Ranks::~Ranks() = default;
void Ranks::send(int, std::span<const std::byte>) const {}
bool Ranks::receive(int, std::span<std::byte>, const std::function<bool()>&) const {
  return false;
}
void Ranks::broadcast(std::span<std::byte>) const {}
void Ranks::add_up(std::span<double>) const {}
void Ranks::end_all(int exit_code) const {
  std::_Exit(exit_code);
}

}  // namespace capcon
#endif
