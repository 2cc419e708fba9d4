#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "scene/known_parameters.h"
#include "scene/pbrt_directives.h"
#include "scene/pbrt_parameters.h"
#include "scene/suggestion.h"

namespace capcon {
namespace {

SourcePlace place_of(const Parameters& parameters, const std::string& name, const SourcePlace& fallback) {
  const auto found = parameters.entries.find(name);
  return found == parameters.entries.end() ? fallback : found->second.place;
}

void camera(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const SourcePlace place = tokens.place(directive);
  const std::string type = read_string(tokens, "Camera");
  if (type != "perspective")
    throw InputError(place, fmt::format("camera \"{}\" is not supported; use \"perspective\"", type));
  const Parameters parameters = read_parameters(tokens);
  note_parameters(context, "Camera", type, parameters);
  Camera& camera = context.scene.camera;
  camera.camera_to_world = glm::inverse(context.state.to_world);
  context.coordinate_systems["camera"] = camera.camera_to_world;

  const bool half = parameters.entries.contains("halffov");  // pbrt-v2 and v3
  camera.fov_degrees = half ? 2 * parameters.number("halffov", 45) : parameters.number("fov", 90);
  if (!(camera.fov_degrees > 0 && camera.fov_degrees < 180)) {
    throw InputError(place_of(parameters, half ? "halffov" : "fov", place),
                     "the field of view must lie between 0 and 180 degrees");
  }
  camera.frame_aspect_ratio = parameters.number("frameaspectratio", 0);
  if (camera.frame_aspect_ratio < 0) {
    throw InputError(place_of(parameters, "frameaspectratio", place),
                     "the frame's aspect ratio must be greater than 0");
  }
  if (const auto* window = parameters.numbers("screenwindow")) {
    const std::vector<double>& w = *window;
    if (w.size() != 4 || w[0] == w[1] || w[2] == w[3]) {
      throw InputError(place_of(parameters, "screenwindow", place),
                       "a screen window is four numbers: x_min x_max y_min y_max");
    }
    std::copy(w.begin(), w.end(), camera.screen.begin());
  }
  if (parameters.number("lensradius", 0) > 0) {
    context.warn(place_of(parameters, "lensradius", place),
                 "depth of field is left out: the lens is a point");
  }
}

int resolution(const Parameters& parameters, const std::string& name, int fallback) {
  const double value = parameters.number(name, fallback);
  if (value >= 1 && value <= 65536 && value == std::floor(value)) return static_cast<int>(value);
  throw InputError(parameters.entries.at(name).place,
                   fmt::format("{} must be a whole number from 1 to 65536", name));
}

void film(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  static const std::vector<std::string_view> kFilms = {"image", "rgb", "gbuffer", "spectral"};
  const std::string type = read_string(tokens, "Film");
  if (std::find(kFilms.begin(), kFilms.end(), type) == kFilms.end()) {
    throw InputError(tokens.place(directive),
                     fmt::format("unknown film \"{}\"{}", type, suggestion(type, kFilms)));
  }
  const Parameters parameters = read_parameters(tokens);
  note_parameters(context, "Film", type, parameters);
  if (type == "gbuffer" || type == "spectral")
    context.note_unused(tokens.place(directive),
                        fmt::format("the film \"{}\" is as \"rgb\": an image of three channels", type));
  Film& film = context.scene.film;
  film.width = resolution(parameters, "xresolution", film.width);
  film.height = resolution(parameters, "yresolution", film.height);
  film.filename = parameters.string("filename", film.filename);
  for (const char* name : {"cropwindow", "pixelbounds"}) {
    if (parameters.entries.contains(name)) {
      context.warn(parameters.entries.at(name).place,
                   "the film's crop is left out: the whole image is rendered");
    }
  }
}

/// Says how to render, which the command line decides here.
void how_to_render(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::string type = read_string(tokens, std::string(directive.text).c_str());
  read_parameters(tokens);
  context.note_unused(
      tokens.place(directive),
      fmt::format("{} \"{}\" is not used: the command line says how to render", directive.text, type));
}

void option(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  for (const auto& [name, entry] : read_parameters(tokens).entries)
    context.note_unused(tokens.place(directive), fmt::format("Option \"{}\" is not used", name));
}

void color_space(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::string name = read_string(tokens, "ColorSpace");
  if (name != "srgb") {
    context.warn(tokens.place(directive),
                 fmt::format("the colour space \"{}\" is left out: colours are taken as sRGB", name));
  }
}

}  // namespace

const std::vector<PbrtDirective>& pbrt_option_directives() {
  static const std::vector<PbrtDirective> kDirectives = {
      {"Camera", PbrtPhase::options, camera},
      {"Film", PbrtPhase::options, film},
      {"PixelFilter", PbrtPhase::options, how_to_render},
      {"Filter", PbrtPhase::options, how_to_render},
      {"Sampler", PbrtPhase::options, how_to_render},
      {"Integrator", PbrtPhase::options, how_to_render},
      {"SurfaceIntegrator", PbrtPhase::options, how_to_render},
      {"VolumeIntegrator", PbrtPhase::options, how_to_render},
      {"Accelerator", PbrtPhase::options, how_to_render},
      {"Renderer", PbrtPhase::options, how_to_render},
      {"Option", PbrtPhase::options, option},
      {"ColorSpace", PbrtPhase::both, color_space},
  };
  return kDirectives;
}

}  // namespace capcon
