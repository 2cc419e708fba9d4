#include "scene/known_parameters.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/suggestion.h"

namespace capcon {
namespace {

/// Names of parameters by directive and types, separated by blanks: those that are read, or spoken of where
/// the type is; and those that pbrt knows besides.
struct Known {
  std::string_view directive, types, read, others;
};

constexpr Known kKnown[] = {
    {"Camera", "perspective", "fov halffov frameaspectratio screenwindow lensradius",
     "focaldistance shutteropen shutterclose"},
    {"Film", "image rgb gbuffer spectral", "xresolution yresolution filename cropwindow pixelbounds",
     "diagonal sensor iso exposuretime imagingratio maxcomponentvalue maxsampleluminance savefp16 "
     "whitebalance scale display nbuckets lambdamin lambdamax coordinatesystem"},
    {"Shape", "trianglemesh", "P N uv st indices alpha", "S faceIndices shadowalpha discarddegenerateUVs"},
    {"Shape", "loopsubdiv", "P N uv st indices alpha", "S levels nlevels scheme shadowalpha"},
    {"Shape", "plymesh objmesh", "filename alpha", "displacement edgelength shadowalpha"},
    {"Shape", "sphere", "radius zmin zmax phimax alpha", "shadowalpha"},
    {"Shape", "disk", "radius height innerradius phimax alpha", "shadowalpha"},
    {"Material", "matte", "Kd sigma", ""},
    {"Material", "diffuse", "reflectance", ""},
    {"Material", "plastic substrate", "Kd Ks roughness uroughness vroughness remaproughness", ""},
    {"Material", "coateddiffuse", "reflectance roughness uroughness vroughness remaproughness eta albedo",
     "thickness g maxdepth nsamples"},
    {"Material", "metal", "eta k roughness uroughness vroughness remaproughness", ""},
    {"Material", "conductor", "eta k reflectance roughness uroughness vroughness remaproughness", ""},
    {"Material", "coatedconductor",
     "reflectance conductor.eta conductor.k conductor.roughness conductor.uroughness conductor.vroughness "
     "remaproughness interface.roughness interface.uroughness interface.vroughness interface.eta thickness g "
     "albedo maxdepth nsamples",
     ""},
    {"Material", "uber", "Kd Ks Kr Kt opacity eta index roughness uroughness vroughness remaproughness", ""},
    {"Material", "measured", "filename", ""},
    {"Material", "mirror", "Kr", ""},
    {"Material", "shinymetal", "Ks Kr roughness uroughness vroughness remaproughness", ""},
    {"Material", "glass", "Kr Kt index eta roughness uroughness vroughness remaproughness", ""},
    {"Material", "dielectric thindielectric", "Kr index eta roughness uroughness vroughness remaproughness",
     ""},
    {"Material", "translucent", "Kd Ks reflect transmit roughness remaproughness", ""},
    {"Material", "diffusetransmission", "reflectance transmittance scale", ""},
    {"Material", "subsurface kdsubsurface",
     "reflectance Kd name eta scale mfp g sigma_a sigma_s sigma_prime_s Kr Kt meanfreepath index roughness "
     "uroughness vroughness remaproughness",
     ""},
    {"Material", "disney", "color metallic roughness eta",
     "anisotropic clearcoat clearcoatgloss difftrans flatness scatterdistance sheen sheentint spectrans "
     "speculartint thin"},
    {"Material", "mix", "namedmaterial1 namedmaterial2 amount materials", ""},
    {"Texture", "constant", "value", ""},
    {"Texture", "scale", "tex scale tex1 tex2", ""},
    {"Texture", "mix", "tex1 tex2 amount", "dir"},
    {"Texture", "imagemap",
     "filename scale invert wrap uscale vscale udelta vdelta mapping encoding gamma v1 v2",
     "filter trilinear maxanisotropy"},
    {"LightSource", "infinite exinfinite", "L scale illuminance filename mapname", "samples nsamples portal"},
    {"LightSource", "distant", "L scale illuminance from to", "samples nsamples"},
    {"LightSource", "point", "I scale power from", "samples nsamples"},
    {"AreaLightSource", "diffuse area", "L scale power twosided filename", "samples nsamples"},
};

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> list;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) list.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return list;
}

bool holds(std::string_view text, std::string_view word) {
  const std::vector<std::string_view> list = words(text);
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

void note_parameters(PbrtContext& context, std::string_view directive, std::string_view type,
                     const Parameters& parameters) {
  if (!context.notes) return;
  const auto known = std::find_if(std::begin(kKnown), std::end(kKnown), [&](const Known& k) {
    return k.directive == directive && holds(k.types, type);
  });
  if (known == std::end(kKnown)) return;
  const std::string what = fmt::format("{} \"{}\"", directive, type);
  for (const auto& [name, entry] : parameters.entries) {
    // Said of any material where it is read; what makes it a named one.
    const bool common = directive == "Material" && holds("bumpmap displacement normalmap type", name);
    if (common || holds(known->read, name)) continue;
    if (holds(known->others, name)) {
      context.notes->add(NoteKind::unused, entry.place, fmt::format("\"{}\" of {} is not used", name, what));
      continue;
    }
    std::vector<std::string_view> names = words(known->read);
    for (const std::string_view other : words(known->others)) names.push_back(other);
    context.notes->add(
        NoteKind::unused, entry.place,
        fmt::format("\"{}\" of {} is not known and not used{}", name, what, suggestion(name, names)));
  }
}

}  // namespace capcon
