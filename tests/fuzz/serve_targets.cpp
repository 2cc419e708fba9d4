// What a page, or whoever else reaches the port, sends to capcon serve.
#include <bit>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "fuzz/target.h"
#include "serve/settings.h"

namespace capcon::fuzz {

void read_serve_settings(std::string_view bytes) {
  const auto body = nlohmann::json::parse(bytes, nullptr, false);
  if (body.is_discarded()) throw InputError("the request is not JSON");
  const serve::Settings s = serve::parse_settings(body, {{"one", "scenes/one.pbrt"}, {"it's", "it's.pbrt"}});
  require(s.scene.file == "scenes/one.pbrt" || s.scene.file == "it's.pbrt", "scenes are those offered");
  require(s.samplers.size() >= 2 && s.samplers.size() <= 6, "two to six samplers");
  require(s.width >= 16 && s.width <= 640 && s.height >= 0 && s.height <= 480, "sizes are small");
  require(s.frame_seconds >= 0.01 && s.frame_seconds <= 60, "a frame time is bounded");
  require(s.radius >= 0 && s.radius <= 1e9 && std::has_single_bit(s.split) && s.split <= 16, "in range");
  const std::string command = serve::command_of(s, s.samplers.front(), 16, 1, s.width, 100);
  for (const unsigned char c : command) require(c >= 0x20 && c != 0x7f, "a command is one line");
  require(serve::largest_count(s, s.samplers.front()) >= serve::first_count(s), "counts ascend");
}

}  // namespace capcon::fuzz
