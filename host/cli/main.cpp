#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file.h"
#include "base/stop.h"
#include "cli/verbs.h"

namespace {

// Exit codes of every verb.
constexpr int kFailure = 1;     // the input was fine, yet the work could not be done
constexpr int kInputError = 2;  // the command line or a file of the user's is wrong
// 128 + N: ended by signal N, see base/stop.h

/// One sentence on stderr, if there is anyone to read it.
void complain(const std::string& sentence) {
  std::fflush(stderr);
  capcon::write_all(STDERR_FILENO, "capcon: " + sentence + "\n");
}

int run(int argc, char** argv) {
  using namespace capcon;
  CLI::App app{
      "capcon: capacity-constrained point sets, and what they are worth in rendering integrals\n\n"
      "  capcon study ambient-occlusion                    error against run time, on the shipped courtyard\n"
      "  capcon render scenes/courtyard.pbrt -o out.exr    one image\n"
      "  capcon points ccvt -n 1024 -o points.txt          one point set\n\n"
      "Exit codes: 0; 1: the work could not be done; 2: the input is wrong; 130: stopped by Ctrl-C (128 and\n"
      "the signal's number). A file is written completely or not at all; a stopped study or large render\n"
      "goes on with the same command.\n",
      "capcon"};
  app.set_version_flag("--version", std::string("capcon ") + std::string(version()));
  app.require_subcommand(1);
  app.fallthrough(false);
  cli::add_study_verb(app);
  cli::add_serve_verb(app);
  cli::add_merge_verb(app);
  cli::add_report_verb(app);
  cli::add_integrate_verb(app);
  cli::add_stability_verb(app);
  cli::add_render_verb(app);
  cli::add_check_verb(app);
  cli::add_compare_verb(app);
  cli::add_points_verb(app);
  cli::add_measure_verb(app);
  cli::add_partition_verb(app);
  cli::add_tiles_verb(app);
  cli::add_ensembles_verb(app);
  cli::add_export_verb(app);
  cli::add_bench_verb(app);
  cli::add_info_verb(app);
  cli::add_documentation_verbs(app);
  try {
    app.parse(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) fail_to_write("standard output");
    return 0;
  } catch (const CLI::Success& help) {
    app.exit(help);
    if (std::cout.flush()) return 0;
    complain("cannot write to standard output: " + reason_of(errno));
  } catch (const CLI::ParseError& error) {
    complain(
        fmt::format("{}; see `capcon{} --help`", error.what(),
                    app.get_subcommands().empty() ? "" : " " + app.get_subcommands().front()->get_name()));
    return kInputError;
  } catch (const InputError& error) {
    complain(error.what());
    return kInputError;
  } catch (const Failure& error) {
    complain(error.what());
  } catch (const std::bad_alloc&) {
    complain("out of memory; try a smaller image, scene or point set");
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.what());
  } catch (const std::system_error& error) {  // what fmt::print throws
    complain("cannot write to standard output or error: " + reason_of(error.code().value()));
  } catch (const std::exception& error) {
    complain(std::string("internal error: ") + error.what());
  }
  return kFailure;
}

}  // namespace

int main(int argc, char** argv) {
  capcon::end_on_signals("capcon");
  return run(argc, argv);
}
