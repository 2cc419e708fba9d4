// The entry of libFuzzer for all targets; $CAPCON_FUZZ_TARGET says which one.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "fuzz/target.h"
#include "sampling/sampler.h"

namespace {

const capcon::fuzz::Target* chosen = nullptr;

}  // namespace

/// Names are all that a reader asks of samplers, which are not linked.
const std::vector<std::string>& capcon::sampler_names() {
  static const std::vector<std::string> names = {"random", "sobol-owen", "ccvt", "fpo", "capcon-domain"};
  return names;
}

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* variable = std::getenv("CAPCON_FUZZ_TARGET");
  const std::string name = variable ? variable : "";
  chosen = capcon::fuzz::find_target(name);
  if (!chosen) {
    std::fprintf(stderr, "there is no target \"%s\"; set CAPCON_FUZZ_TARGET to one of:", name.c_str());
    for (const auto& target : capcon::fuzz::targets())
      std::fprintf(stderr, " %.*s", static_cast<int>(target.name.size()), target.name.data());
    std::fprintf(stderr, "\n");
    std::exit(2);
  }
  ::setenv("CAPCON_THREADS", "1", 0);  // threads of an input of a few bytes cost more than it does
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  capcon::fuzz::check(*chosen, {reinterpret_cast<const char*>(data), size});
  return 0;
}
