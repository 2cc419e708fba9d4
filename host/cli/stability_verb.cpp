#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/stop.h"
#include "cli/verbs.h"
#include "gpu/instance.h"
#include "stability/page.h"
#include "stability/suite.h"

namespace capcon::cli {
namespace {

struct Options {
  stability::SuiteOptions suite;
  std::string directory;
  bool list = false, json = false, quiet = false;
};

/// A folder that goes away with the run.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "capcon-stability-XXXXXX").string();
    const StopLater to_register;
    if (!::mkdtemp(pattern.data()))
      throw Failure("no folder can be made in " + std::filesystem::temp_directory_path().string());
    path_ = pattern;
    register_temporary(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    const StopLater to_forget;
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    forget_temporary(path_);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string command_line(const Options& o) {
  std::string command = "capcon stability";
  if (o.suite.brief) command += " --brief";
  for (const std::string& name : o.suite.only) command += fmt::format(" --only \"{}\"", name);
  if (o.suite.device != "best") command += " --device " + o.suite.device;
  return command;
}

void run(Options& o) {
  namespace fs = std::filesystem;
  if (o.list) {
    for (const auto& [group, name] : stability::names_of_checks(o.suite))
      fmt::print("{:<18} {}\n", group, name);
    return;
  }
  std::unique_ptr<TemporaryFolder> temporary;
  if (o.directory.empty()) {
    temporary = std::make_unique<TemporaryFolder>();
    o.suite.folder = temporary->path().string();
  } else {
    fs::create_directories(o.directory);
    check_writable(fs::path(o.directory) / "stability.html");
    o.suite.folder = (fs::path(o.directory) / "scenes").string();
  }
  std::vector<stability::Check> checks;
  {
    Progress progress("stability", 1, o.quiet);
    std::size_t done = 0;
    checks = stability::run_suite(o.suite, [&](const stability::Check& check, std::size_t all) {
      progress.update(static_cast<double>(++done) / static_cast<double>(all), check.name);
    });
  }
  const bool passed = std::all_of(checks.begin(), checks.end(), [](const auto& c) { return c.passed; });
  const nlohmann::ordered_json json = {
      {"passed", passed}, {"command", command_line(o)}, {"version", version()}, {"checks", to_json(checks)}};
  if (!o.directory.empty()) {
    write_file(fs::path(o.directory) / "stability.json", json.dump(1) + "\n");
    write_file(fs::path(o.directory) / "stability.html", stability_page(checks, command_line(o)));
  }
  if (o.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}", to_text(checks));
  }
  if (!o.directory.empty() && !o.quiet)
    fmt::print(stderr, "The page is {}\n",
               fs::absolute(fs::path(o.directory) / "stability.html").lexically_normal().string());
  if (!passed) throw Failure("the suite of numerical stability did not pass: see the lines that say FAILED");
}

}  // namespace

void add_stability_verb(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("stability",
                         "stiff and extreme cases: the device's floats against the reference in double\n\n"
                         "  capcon stability -o report/stability       all, in less than ten minutes\n"
                         "  capcon stability --brief                   a case of each kind\n"
                         "  capcon stability --only limits             where floats end\n");
  auto o = std::make_shared<Options>();
  verb->add_option("-o,--output", o->directory, "folder for stability.html, stability.json and every scene");
  verb->add_option("--only", o->suite.only, "checks or groups, as --list names them")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  verb->add_option("--device", o->suite.device, "as for render")->capture_default_str();
  verb->add_flag("--brief", o->suite.brief, "the short form, as CI runs it");
  verb->add_flag("--list", o->list, "print the names of the checks");
  verb->add_flag("--json", o->json, "print stability.json instead of the table");
  verb->add_flag("--quiet", o->quiet, "no progress and no messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
