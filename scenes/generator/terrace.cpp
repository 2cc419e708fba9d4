#include "generator/terrace.h"

#include "base/file.h"
#include "generator/lacquer.h"
#include "generator/sky.h"
#include "image/image.h"

namespace capcon::scenes {

Assembly terrace() {
  Assembly scene("splitting");
  belvedere::add_floor(scene);
  belvedere::add_balustrade(scene);
  belvedere::add_columns(scene);
  belvedere::add_wares(scene);
  belvedere::add_plants(scene);
  return scene;
}

void write_terrace_data(const std::filesystem::path& folder) {
  write_exr(folder / "sky.exr", sky_map({}, 512));
  write_file(folder / "lacquer.brdf", lacquer_table());
}

}  // namespace capcon::scenes
