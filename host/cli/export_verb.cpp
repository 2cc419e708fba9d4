#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "cli/verbs.h"
#include "image/image.h"
#include "points/ensemble_file.h"
#include "sampling/ensemble_store.h"
#include "sampling/export_sets.h"

namespace capcon::cli {
namespace {

struct Options {
  std::uint32_t points = 16;
  std::string domain = "disk", file;
  bool json = false;
};

void write_sets_exr(const std::filesystem::path& path, const Ensemble& e, const Options& o) {
  const auto n = static_cast<int>(o.points);
  Image image(n, static_cast<int>(e.sets), 3);
  for (int s = 0; s < image.height; ++s) {
    for (int i = 0; i < n; ++i) {
      const std::uint32_t c = e.cells[std::size_t(s) * o.points + std::size_t(i)];
      image.at(i, s, 0) = static_cast<float>(double(c % e.columns) / e.columns);
      image.at(i, s, 1) = static_cast<float>(double(c / e.columns) / e.rows);
      image.at(i, s, 2) = static_cast<float>(c);
    }
  }
  write_exr(
      path, image,
      {{"domain", o.domain}, {"columns", static_cast<int>(e.columns)}, {"rows", static_cast<int>(e.rows)}});
}

void run(const Options& o) {
  const EnsembleDomain domain = o.domain == "disk"     ? EnsembleDomain::disk
                                : o.domain == "square" ? EnsembleDomain::square
                                                       : EnsembleDomain::cylinder;
  const std::filesystem::path path(o.file);
  const std::string kind = path.extension().string();
  if (kind != ".h" && kind != ".glsl" && kind != ".npy" && kind != ".exr") {
    throw InputError(fmt::format(
        "{}: sets are exported as .h (C), .glsl, .npy (NumPy) or .exr; name the file so", o.file));
  }
  if (o.points > kMostEnsemblePoints || !can_make_ensemble(o.points)) {
    throw InputError(
        fmt::format("there are no sets of {} points; take 1 to 1024, or a multiple of 64 up to {}", o.points,
                    kMostEnsemblePoints));
  }
  check_writable(path);
  const Ensemble e = stored_ensemble(o.points, domain);
  if (kind == ".exr") {
    write_sets_exr(path, e, o);
  } else {
    write_file(path, kind == ".h"      ? as_c_header(e, domain)
                     : kind == ".glsl" ? as_glsl(e, domain)
                                       : as_numpy(e));
  }
  if (o.json) {
    const nlohmann::ordered_json json = {{"file", o.file},     {"domain", o.domain},   {"sets", e.sets},
                                         {"points", o.points}, {"columns", e.columns}, {"rows", e.rows}};
    fmt::print("{}\n", json.dump(2));
  }
}

}  // namespace

void add_export_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "export",
      "the sets of capcon-domain for other programs: a C header, a GLSL include, a NumPy array or an EXR\n\n"
      "Examples:\n"
      "  capcon export -n 16 -o sets.h                    256 sets of 16 points of the disk, with a "
      "function\n"
      "  capcon export -n 64 --domain square -o sets.npy  an array (sets, points, 4) of cells\n");
  auto options = std::make_shared<Options>();
  verb->add_option("-n,--points", options->points, "Points of a set")->capture_default_str();
  verb->add_option("--domain", options->domain,
                   "Where they live: disk (hemispheres, disk lights), square, cylinder "
                   "(azimuth and height: spheres, environments)")
      ->capture_default_str()
      ->check(CLI::IsMember({"disk", "square", "cylinder"}));
  verb->add_option("-o,--output", options->file, "The file; its ending says what: .h .glsl .npy .exr")
      ->required();
  verb->add_flag("--json", options->json, "Print one JSON object");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
