#include "distributed/launcher.h"

#include <cstdlib>
#include <initializer_list>

namespace capcon {
namespace {

/// 0 where there is no such number.
int number(const char* name) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : 0;
}

}  // namespace

bool launched_together() {
  for (const char* size : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (std::getenv(size)) return number(size) > 1;
  // PMIx names the rank alone. Slurm tells everybody the number of tasks, with MPI or without.
  return std::getenv("PMIX_RANK") && (number("PMIX_RANK") > 0 || number("SLURM_NTASKS") > 1);
}

}  // namespace capcon
