#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "scene/suggestion.h"
#include "shading/material_reader.h"
#include "shading/metals.h"
#include "shading/roughness.h"

namespace capcon {
namespace {

constexpr glm::dvec3 kBlack(0), kWhite(1);

Material diffuse_of(MaterialReader& reader, const char* name) {
  Material material;
  reader.albedo(material, name, 0.5);
  return material;
}

Material diffuse(MaterialReader& reader) {
  return diffuse_of(reader, "reflectance");
}

Material matte(MaterialReader& reader) {
  if (reader.number("sigma", 0) > 0) reader.say("its sigma is left out: it is Lambertian");
  return diffuse_of(reader, "Kd");
}

Material plastic_of(glm::dvec3 specular, double index, double alpha) {
  Material material;
  material.kind = MaterialKind::plastic;
  material.specular = specular;
  material.eta = glm::dvec3(index);
  material.alpha = alpha;
  return material;
}

Material plastic(MaterialReader& reader) {
  const glm::dvec3 specular = reader.reflectance("Ks", glm::dvec3(0.25));
  Material material = plastic_of(specular, 1.5, reader.alpha_old(0.1));
  reader.albedo(material, "Kd", 0.25);
  return material;
}

Material substrate(MaterialReader& reader) {
  const glm::dvec3 specular = reader.reflectance("Ks", glm::dvec3(0.5));
  Material material = plastic_of(specular, 1, reader.alpha_old(0.1));
  material.coat = Coat::substrate;
  reader.albedo(material, "Kd", 0.5);
  return material;
}

/// Dielectrics do not disperse here: green stands for all colours.
double index_of(MaterialReader& reader, const std::string& name) {
  return std::max(1.0, reader.colour(name, glm::dvec3(1.5)).g);
}

Material coated_diffuse(MaterialReader& reader) {
  const double index = index_of(reader, "eta");
  Material material = plastic_of(kWhite, index, reader.alpha_new(0));
  material.coat = Coat::transmitted;
  reader.albedo(material, "reflectance", 0.5);
  if (reader.colour("albedo", kBlack) != kBlack) reader.say("its coat is clear");
  return material;
}

Material conductor_of(glm::dvec3 eta, glm::dvec3 k, double alpha) {
  Material material;
  material.kind = MaterialKind::conductor;
  material.reflectance = kBlack;
  material.eta = eta;
  material.k = k;
  material.alpha = alpha;
  return material;
}

/// All light is reflected, times `tint`: eta = 0 makes the Fresnel reflectance 1 at all angles.
Material tinted_mirror(const glm::dvec3& tint, double alpha) {
  Material material = conductor_of(kBlack, kWhite, alpha);
  material.specular = tint;
  return material;
}

Material metal_of(MaterialReader& reader, const std::string& prefix, double alpha) {
  const glm::dvec3 eta = *named_metal_spectrum("metal-Cu-eta"), k = *named_metal_spectrum("metal-Cu-k");
  const glm::dvec3 own_eta = reader.colour(prefix + "eta", eta);
  return conductor_of(own_eta, reader.colour(prefix + "k", k), alpha);
}

/// pbrt-v4's "reflectance" of a metal: eta = 1 and the k that reflects so much at normal incidence.
Material metal_of_reflectance(MaterialReader& reader, double alpha) {
  const glm::dvec3 r = glm::min(reader.reflectance("reflectance", kWhite), glm::dvec3(0.9999));
  return conductor_of(kWhite, 2.0 * glm::sqrt(r) / glm::sqrt(1.0 - r), alpha);
}

Material metal(MaterialReader& reader) {
  return metal_of(reader, {}, reader.alpha_old(0.01));
}

Material conductor(MaterialReader& reader) {
  const double alpha = reader.alpha_new(0);
  return reader.has("reflectance") ? metal_of_reflectance(reader, alpha) : metal_of(reader, {}, alpha);
}

Material coated_conductor(MaterialReader& reader) {
  reader.say("it has no coat");
  const double alpha = reader.alpha_new(0, "conductor.");
  return reader.has("reflectance") ? metal_of_reflectance(reader, alpha)
                                   : metal_of(reader, "conductor.", alpha);
}

Material mirror(MaterialReader& reader) {
  reader.say(fmt::format("it is a metal of GGX alpha {}", kSmallestAlpha));
  return tinted_mirror(reader.reflectance("Kr", glm::dvec3(0.9)), kSmallestAlpha);
}

Material shiny_metal(MaterialReader& reader) {
  reader.say("its mirror is left out, and its gloss does not depend on the angle");
  const glm::dvec3 tint = reader.reflectance("Ks", kWhite);
  return tinted_mirror(tint, reader.alpha_old(0.1));
}

Material uber(MaterialReader& reader) {
  const double index = index_of(reader, reader.has("eta") ? "eta" : "index");
  const glm::dvec3 specular = reader.reflectance("Ks", glm::dvec3(0.25));
  Material material = plastic_of(specular, index, reader.alpha_old(0.1));
  reader.albedo(material, "Kd", 0.25);
  if (reader.colour("Kr", kBlack) != kBlack) reader.say("its mirror \"Kr\" is left out");
  if (reader.colour("Kt", kBlack) != kBlack) reader.say("what it transmits is left out");
  if (reader.colour("opacity", kWhite) != kWhite) reader.say("it is opaque");
  return material;
}

Material translucent(MaterialReader& reader) {
  reader.say("what it transmits is left out");
  const glm::dvec3 part = reader.reflectance("reflect", glm::dvec3(0.5));
  const glm::dvec3 specular = reader.reflectance("Ks", glm::dvec3(0.25)) * part;
  Material material = plastic_of(specular, 1.5, reader.alpha_old(0.1));
  reader.albedo(material, "Kd", 0.25, (part.x + part.y + part.z) / 3);
  return material;
}

Material glass(MaterialReader& reader) {
  reader.say("what it transmits is left out: it is a black plastic");
  const bool is_new = reader.entity().type != "glass";
  const double index = index_of(reader, reader.has("index") ? "index" : "eta");
  const double alpha = is_new ? reader.alpha_new(0) : reader.alpha_old(0);
  Material material = plastic_of(reader.reflectance("Kr", kWhite), index, alpha);
  material.reflectance = kBlack;
  return material;
}

Material diffuse_transmission(MaterialReader& reader) {
  reader.say("what it transmits is left out");
  Material material;
  reader.albedo(material, "reflectance", 0.25, read_number(reader.entity().parameters, "scale", 1, 0));
  return material;
}

Material subsurface(MaterialReader& reader) {
  reader.say("light does not enter it: it is diffuse");
  return diffuse_of(reader, reader.entity().type == "kdsubsurface" ? "Kd" : "reflectance");
}

Material disney(MaterialReader& reader) {
  const bool is_metal = reader.number("metallic", 0) > 0.5;
  const double r = reader.number("roughness", 0.5), alpha = std::clamp(r * r, kSmallestAlpha, 1.0);
  reader.say(is_metal ? "it is a metal of its colour" : "it is a plastic of its colour");
  if (is_metal) return tinted_mirror(reader.reflectance("color", glm::dvec3(0.5)), alpha);
  Material material = plastic_of(kWhite, index_of(reader, "eta"), alpha);
  material.coat = Coat::transmitted;
  reader.albedo(material, "color", 0.5);
  return material;
}

Material hair(MaterialReader& reader) {
  reader.say("it is diffuse");
  return diffuse_of(reader, reader.has("reflectance") ? "reflectance" : "color");
}

Material fourier(MaterialReader& reader) {
  reader.say("its table is not read, and it is grey");
  return {};
}

Material measured(MaterialReader& reader) {
  const std::string file = reader.entity().parameters.string("filename", {});
  if (file.empty())
    throw InputError(reader.entity().place, "a measured material needs its \"string filename\"");
  if (file.ends_with(".bsdf")) {
    reader.say("pbrt-v4's .bsdf tables are not read, and it is grey");
    return {};
  }
  Material material;
  material.measured = reader.measured(file);
  if (material.measured >= 0) material.kind = MaterialKind::measured;
  return material;
}

Material mix(MaterialReader& reader) {
  const Parameters& parameters = reader.entity().parameters;
  std::string names[2] = {parameters.string("namedmaterial1", {}), parameters.string("namedmaterial2", {})};
  const double amount = reader.number("amount", 0.5);
  double second = 1 - amount;  // pbrt-v3 gives the share of the first, v4 that of the second
  if (const Parameters::Entry* entry = find_entry(parameters, "materials")) {
    const auto* two = std::get_if<std::vector<std::string>>(&entry->value);
    if (!two || two->size() != 2) throw InputError(entry->place, "\"materials\" must name two materials");
    std::copy(two->begin(), two->end(), names);
    second = amount;
  }
  const std::string& chosen = names[second > 0.5 ? 1 : 0];
  reader.say(fmt::format("of what it mixes it is \"{}\" alone", chosen));
  return reader.other(chosen);
}

Material none(MaterialReader& reader) {
  reader.say("it is a black surface, where pbrt lets rays pass");
  Material material;
  material.reflectance = kBlack;
  return material;
}

}  // namespace

const std::vector<MaterialType>& material_types() {
  static const std::vector<MaterialType> kTypes = {{"matte", matte},
                                                   {"diffuse", diffuse},
                                                   {"plastic", plastic},
                                                   {"coateddiffuse", coated_diffuse},
                                                   {"substrate", substrate},
                                                   {"metal", metal},
                                                   {"conductor", conductor},
                                                   {"coatedconductor", coated_conductor},
                                                   {"uber", uber},
                                                   {"measured", measured},
                                                   {"mirror", mirror},
                                                   {"shinymetal", shiny_metal},
                                                   {"glass", glass},
                                                   {"dielectric", glass},
                                                   {"thindielectric", glass},
                                                   {"translucent", translucent},
                                                   {"diffusetransmission", diffuse_transmission},
                                                   {"subsurface", subsurface},
                                                   {"kdsubsurface", subsurface},
                                                   {"disney", disney},
                                                   {"hair", hair},
                                                   {"fourier", fourier},
                                                   {"mix", mix},
                                                   {"interface", none},
                                                   {"none", none},
                                                   {"", none}};
  return kTypes;
}

Material read_material(MaterialReader& reader) {
  const std::string& type = reader.entity().type;
  for (const MaterialType& known : material_types()) {
    if (known.name != type) continue;
    const Material material = known.read(reader);
    for (const char* bump : {"bumpmap", "displacement", "normalmap"}) {
      if (reader.has(bump)) reader.say("its bumps are left out");
    }
    return material;
  }
  std::vector<std::string_view> names;
  for (const MaterialType& known : material_types()) names.push_back(known.name);
  reader.say(fmt::format("there is no such material, the default is used{}", suggestion(type, names)));
  return {};
}

}  // namespace capcon
