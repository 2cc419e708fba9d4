// Fuzzes the reader of Cornell's BRDF tables: whatever the bytes, the answer is samples that are finite and
// not negative or an InputError. See README.md beside.
#include "base/error.h"
#include "fuzz_check.h"
#include "shading/measured_brdf.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const capcon::CornellBrdf brdf = capcon::parse_cornell_brdf(bytes, "f.brdf");
    capcon::fuzz::require(!brdf.samples.empty());
    for (const capcon::BrdfSample& sample : brdf.samples) {
      for (int c = 0; c < 3; ++c)
        capcon::fuzz::require(std::isfinite(sample.value[c]) && sample.value[c] >= 0);
    }
  } catch (const capcon::InputError&) {
  }
  return 0;
}
