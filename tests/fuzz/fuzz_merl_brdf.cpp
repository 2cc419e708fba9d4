// Fuzzes the reader of MERL's BRDF binaries: whatever the bytes, the answer is a table of the size it says,
// measured values finite and not negative, or an InputError. See README.md beside.
#include "base/error.h"
#include "fuzz_check.h"
#include "shading/measured_brdf.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const capcon::MerlBrdf brdf = capcon::parse_merl_brdf(bytes, "f.binary");
    capcon::fuzz::require(brdf.values.size() ==
                          static_cast<std::size_t>(brdf.size[0]) * brdf.size[1] * brdf.size[2]);
    for (const glm::vec3& value : brdf.values) {
      for (int c = 0; c < 3; ++c)
        capcon::fuzz::require(std::isfinite(value[c]) && (value[c] >= 0 || value == glm::vec3(-1)));
    }
  } catch (const capcon::InputError&) {
  }
  return 0;
}
