#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "base/error.h"
#include "base/file.h"
#include "cli/verbs.h"

namespace {

// Exit codes of every verb.
constexpr int kFailure = 1;     // the input was fine, yet the work could not be done
constexpr int kInputError = 2;  // the command line or a file of the user's is wrong

int run(int argc, char** argv) {
  using namespace capcon;
  CLI::App app{
      "capcon: capacity-constrained point sets, and what they are worth in rendering integrals\n\n"
      "  capcon study ambient-occlusion                    error against run time, on the shipped courtyard\n"
      "  capcon render scenes/courtyard.pbrt -o out.exr    one image\n"
      "  capcon points ccvt -n 1024 -o points.txt          one point set\n",
      "capcon"};
  app.set_version_flag("--version", std::string("capcon ") + std::string(version()));
  app.require_subcommand(1);
  app.fallthrough(false);
  cli::add_study_verb(app);
  cli::add_integrate_verb(app);
  cli::add_render_verb(app);
  cli::add_compare_verb(app);
  cli::add_points_verb(app);
  cli::add_measure_verb(app);
  cli::add_partition_verb(app);
  cli::add_tiles_verb(app);
  cli::add_ensembles_verb(app);
  cli::add_bench_verb(app);
  cli::add_info_verb(app);
  try {
    app.parse(argc, argv);
    std::fflush(stdout);
    if (std::ferror(stdout)) throw Failure("cannot write to standard output");
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "capcon: {}; see `capcon{} --help`\n", error.what(),
               app.get_subcommands().empty() ? "" : " " + app.get_subcommands().front()->get_name());
    return kInputError;
  } catch (const InputError& error) {
    fmt::print(stderr, "capcon: {}\n", error.what());
    return kInputError;
  } catch (const Failure& error) {
    fmt::print(stderr, "capcon: {}\n", error.what());
    return kFailure;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "capcon: out of memory; try a smaller image, scene or point set\n");
    return kFailure;
  } catch (const std::exception& error) {
    fmt::print(stderr, "capcon: internal error: {}\n", error.what());
    return kFailure;
  }
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv); }
