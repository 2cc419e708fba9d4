#include "plot/picture_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "plot/indexed_png.h"
#include "plot/palette.h"
#include "plot/raster_canvas.h"
#include "plot/svg_canvas.h"

namespace capcon::plot {

void check_picture_name(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".svg" && extension != ".png")
    throw InputError(fmt::format("{}: a picture is written as .svg or .png", path));
  check_writable(path);
}

void write_picture(const std::string& path, double width, double height,
                   const std::function<void(Canvas&)>& draw, double scale) {
  if (std::filesystem::path(path).extension() == ".svg") {
    SvgCanvas canvas(width, height, kGround);
    draw(canvas);
    return write_file(path, canvas.str());
  }
  if (width * height * scale * scale > 2e8)
    throw Failure(
        fmt::format("{}: a picture of {:.0f} x {:.0f} pixels is too large for a PNG; write an SVG instead",
                    path, width * scale, height * scale));
  RasterCanvas canvas(width, height, kGround, scale);
  draw(canvas);
  write_file(path, encode_png(canvas.pixels()));
}

}  // namespace capcon::plot
