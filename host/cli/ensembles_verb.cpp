#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "cli/verbs.h"
#include "sampling/ensemble_store.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string folder, file;
  bool quiet = false;
};

void make(const Options& o) {
  const EnsembleDomain domains[] = {EnsembleDomain::disk, EnsembleDomain::square, EnsembleDomain::cylinder};
  create_folder(o.folder);
  const auto file = [&](EnsembleDomain domain) {
    return std::filesystem::path(o.folder) / fmt::format("{}.ensembles", domain_name(domain));
  };
  for (const EnsembleDomain domain : domains) check_writable(file(domain));
  Progress progress("ensembles", 3, o.quiet);
  double done = 0;
  for (const EnsembleDomain domain : domains) {
    progress.update(done++, std::string(domain_name(domain)));
    write_file(file(domain), make_shipped_ensembles(domain));
  }
}

void show(const Options& o) {
  for (const StoredEnsemble& s : parse_ensembles(read_file(o.file), o.file)) {
    fmt::print("{:8} {:5} points {:5} sets of {} x {} cells, mean distance within {:.6f}\n",
               domain_name(s.options.domain), s.options.points, s.ensemble.sets, s.ensemble.columns,
               s.ensemble.rows, mean_distance_within(s.ensemble, s.options.domain));
  }
}

}  // namespace

void add_ensembles_verb(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("ensembles",
                         "the sets of the sampler capcon-domain: make the shipped files again, or "
                         "show what a file holds\n");
  verb->require_subcommand(1);
  auto options = std::make_shared<Options>();
  CLI::App* making = verb->add_subcommand("make", "make the shipped files again, to the bit");
  making->add_option("-o,--output", options->folder, "the folder for disk, square and cylinder.ensembles")
      ->required();
  making->add_flag("--quiet", options->quiet, "no progress");
  making->callback([options] { make(*options); });
  CLI::App* showing = verb->add_subcommand("show", "check a file and list its sets");
  showing->add_option("FILE", options->file, "a file of ensembles")->required();
  showing->callback([options] { show(*options); });
}

}  // namespace capcon::cli
