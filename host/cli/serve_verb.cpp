#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stop.h"
#include "cli/verbs.h"
#include "serve/server.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string scene, device = "best";
  int port = 8080;
  bool json = false, quiet = false;
};

void run(const Options& o) {
  serve::Server server({o.port, o.device, serve::offered_scenes(o.scene)});
  const StopMessage stop("the page is closed");
  const std::string url = fmt::format("http://127.0.0.1:{}/", server.port());
  if (o.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"url", url}, {"port", server.port()}}.dump());
  } else {
    fmt::print("{}\n", url);
  }
  std::fflush(stdout);
  if (!o.quiet) {
    fmt::print(stderr,
               "capcon: open the address above in a browser; Ctrl-C ends. From another machine: ssh -L "
               "{0}:127.0.0.1:{0} HOST\n",
               server.port());
  }
  server.run();
}

}  // namespace

void add_serve_verb(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("serve", "Compare samplers in the browser, by eye and by clock (127.0.0.1 only)");
  auto o = std::make_shared<Options>();
  verb->footer(
      "Examples:\n"
      "  capcon serve\n"
      "  capcon serve scenes/direct.pbrt --port 0 --device lavapipe");
  verb->add_option("scene", o->scene, "Scene that is chosen at first; those in its folder can be chosen too");
  verb->add_option("--port", o->port, "Port at 127.0.0.1; 0: a free one")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  verb->add_option("--device", o->device, "best, lavapipe, a number or name of `capcon info`, or reference")
      ->capture_default_str();
  verb->add_flag("--json", o->json, "Print the address as JSON on stdout");
  verb->add_flag("--quiet", o->quiet, "No messages");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
