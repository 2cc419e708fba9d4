#pragma once

#include <memory>
#include <string>
#include <vector>

#include "serve/settings.h"

namespace capcon::serve {

struct ServerOptions {
  int port = 8080;  ///< 0: a free one
  std::string device = "best";
  std::vector<OfferedScene> scenes;   ///< the first is chosen at first
  int patience_milliseconds = 15000;  ///< of a page that does not ask any more
};

/// The page and what it asks for, at 127.0.0.1 only.
class Server {
 public:
  /// Failure where the port is taken.
  explicit Server(ServerOptions options);
  ~Server();
  int port() const;
  /// Serves until stop(), which any thread may call.
  void run();
  void stop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Shipped scenes, and before them `given` (may be empty) and the other .pbrt files of its folder. InputError
/// where it is not there.
std::vector<OfferedScene> offered_scenes(const std::string& given);

}  // namespace capcon::serve
