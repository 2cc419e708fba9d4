// Fuzzes the pbrt reader: whatever the bytes, the answer is a scene whose indices hold or an InputError. See
// README.md beside.
#include "base/error.h"
#include "fuzz_check.h"
#include "scene/pbrt_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    capcon::fuzz::check(capcon::parse_pbrt(bytes, "f.pbrt", {true, true}));
  } catch (const capcon::InputError&) {
  }
  return 0;
}
