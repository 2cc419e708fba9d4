#pragma once

#include <httplib.h>

#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "cli/program.h"
#include "image/image.h"
#include "serve/server.h"

namespace capcon::testing {

using nlohmann::json;

inline const std::string kScene = CAPCON_SOURCE_DIR "/scenes/courtyard.pbrt";

/// Lamp, floor and ball: what is held of it is small beside what a leak would add up to.
inline std::string small_scene(const Folder& folder) {
  return folder.write("small.pbrt",
                      "LookAt 0 -4 3 0 0 .5 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
                      "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 12\nWorldBegin\n"
                      "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate .5 0 2\n"
                      "Rotate 180 1 0 0\nShape \"disk\" \"float radius\" .6\nAttributeEnd\n"
                      "Material \"diffuse\" \"rgb reflectance\" [.6 .4 .3]\nShape \"trianglemesh\" "
                      "\"point3 P\" [-2 -2 0 2 -2 0 2 2 0 -2 2 0] \"integer indices\" [0 1 2 0 2 3]\n"
                      "Shape \"sphere\" \"float radius\" .5\n");
}

/// A server on a free port, for one test.
class Served {
 public:
  explicit Served(int patience = 15000, const std::string& scene = kScene)
      : server_({0, "lavapipe", serve::offered_scenes(scene), patience}),
        thread_([this] { server_.run(); }) {}
  ~Served() { server_.stop(); }
  int port() const { return server_.port(); }
  std::string url() const { return "http://127.0.0.1:" + std::to_string(port()) + "/"; }
  httplib::Client client() const {
    httplib::Client client("127.0.0.1", port());
    client.set_read_timeout(20);
    return client;
  }
  httplib::Result start(json body, const httplib::Headers& headers = {}) const {
    return client().Post("/api/start", headers, body.dump(), "application/json");
  }

 private:
  serve::Server server_;
  std::jthread thread_;
};

inline json small(const std::string& client = "me") {
  return {{"client", client},
          {"samplers", {"random", "sobol-owen"}},
          {"width", 32},
          {"frame_seconds", 0.02},
          {"radius", 2}};
}

inline json snapshot_when(const Served& served, const std::string& id,
                          const std::function<bool(const json&)>& there) {
  json s;
  for (int i = 0; i < 6000; ++i) {
    s = json::parse(served.client().Get("/api/comparison?client=me&id=" + id)->body);
    if (there(s) || s.value("state", "") == "failed") return s;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return s;
}

/// What the server hands out of a sampler's first frame of this count.
inline Image image_of(const Served& served, const std::string& id, const std::string& sampler, int count) {
  const auto r = served.client().Get("/api/image?client=me&id=" + id + "&sampler=" + sampler +
                                     "&count=" + std::to_string(count));
  std::uint32_t head[3];
  if (r->status != 200 || r->body.size() < sizeof head) return {};
  std::memcpy(head, r->body.data(), sizeof head);
  Image image(static_cast<int>(head[0]), static_cast<int>(head[1]), static_cast<int>(head[2]));
  if (r->body.size() != sizeof head + image.pixels.size() * 4) return {};
  std::memcpy(image.pixels.data(), r->body.data() + sizeof head, image.pixels.size() * 4);
  return image;
}

}  // namespace capcon::testing
