#include "serve/server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <bit>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "sampling/sampler.h"
#include "serve/hub.h"
#include "serve/page.h"

namespace capcon::serve {
namespace {

using httplib::Request;
using httplib::Response;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kJson = "application/json";

void refuse(Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(ordered_json{{"error", sentence}}.dump(-1, ' ', false, json::error_handler_t::replace),
                       kJson);
}

/// "localhost:8080" and the like. The port may be any, since it may be forwarded; the name may not, or any
/// page could have its own name resolve to this machine (DNS rebinding).
bool is_local(std::string_view host) {
  const auto colon = host.rfind(':');
  if (colon != std::string_view::npos && host.find(']', colon) == std::string_view::npos) {
    const std::string_view port = host.substr(colon + 1);
    if (port.empty() || port.size() > 5 || port.find_first_not_of("0123456789") != std::string_view::npos)
      return false;
    host = host.substr(0, colon);
  }
  return host == "127.0.0.1" || host == "localhost" || host == "[::1]";
}

bool is_local_origin(std::string_view origin) {
  return origin.starts_with("http://") && is_local(origin.substr(7));
}

/// Of the client's own making; it tells pages apart and opens nothing.
std::string client_of(const std::string& text) {
  const auto fine = [](unsigned char c) { return std::isalnum(c) != 0; };
  if (text.empty() || text.size() > 40 || !std::all_of(text.begin(), text.end(), fine))
    throw InputError("\"client\" must be 1 to 40 letters and digits");
  return text;
}

/// Three 32-bit words (width, height, channels) and floats, little endian as all our machines are.
std::string encoded(const Image& image) {
  static_assert(std::endian::native == std::endian::little);
  const std::uint32_t head[3] = {std::uint32_t(image.width), std::uint32_t(image.height),
                                 std::uint32_t(image.channels)};
  std::string bytes(reinterpret_cast<const char*>(head), sizeof head);
  bytes.append(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(float));
  return bytes;
}

}  // namespace

struct Server::State {
  explicit State(ServerOptions o)
      : options(std::move(o)), hub(std::chrono::milliseconds(options.patience_milliseconds)) {}

  ServerOptions options;
  Hub hub;
  httplib::Server http;
  int port = 0;

  void limits();
  void routes();
  bool refused(const Request& request, Response& response) const;
  ordered_json setup() const;
  void start(const Request& request, Response& response);
  void image(const Request& request, Response& response);
};

void Server::State::limits() {
  http.new_task_queue = [] { return new httplib::ThreadPool(12); };
  http.set_payload_max_length(16 * 1024);
  http.set_keep_alive_max_count(1);  // a connection that waits would hold a thread, and a page opens six
  http.set_read_timeout(5);
  http.set_write_timeout(10);
  // SO_REUSEADDR alone: with httplib's SO_REUSEPORT a second server would share a port that is taken.
  http.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  http.set_default_headers(
      {{"Cache-Control", "no-store"},
       {"X-Content-Type-Options", "nosniff"},
       {"X-Frame-Options", "DENY"},
       {"Referrer-Policy", "no-referrer"},
       {"Content-Security-Policy", "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'"}});
}

bool Server::State::refused(const Request& request, Response& response) const {
  if (!is_local(request.get_header_value("Host"))) {
    refuse(response, 403, "this page is for 127.0.0.1 and localhost only: open it under one of these names");
    return true;
  }
  if (request.has_header("Origin") && !is_local_origin(request.get_header_value("Origin"))) {
    refuse(response, 403, "requests from other origins are refused");
    return true;
  }
  static const std::map<std::string, std::string> methods = {
      {"/", "GET"},           {"/page.css", "GET"},       {"/page.js", "GET"},
      {"/api/setup", "GET"},  {"/api/comparison", "GET"}, {"/api/image", "GET"},
      {"/api/start", "POST"}, {"/api/leave", "POST"}};
  const auto route = methods.find(request.path);
  if (route == methods.end()) {
    refuse(response, 404, "there is nothing here; the page is at /");
    return true;
  }
  if (request.method != route->second && !(request.method == "HEAD" && route->second == "GET")) {
    response.set_header("Allow", route->second);
    refuse(response, 405, fmt::format("{} answers {} only", route->first, route->second));
    return true;
  }
  return false;
}

ordered_json Server::State::setup() const {
  ordered_json out = {{"samplers", sampler_names()}, {"integrators", {"ao", "direct", "igi"}}};
  for (const OfferedScene& scene : options.scenes) out["scenes"].push_back(scene.name);
  out["devices"] = {options.device};
  for (const char* device : {"best", "lavapipe", "reference"})
    if (device != options.device) out["devices"].push_back(device);
  return out;
}

void Server::State::start(const Request& request, Response& response) {
  if (!request.get_header_value("Content-Type").starts_with(kJson))
    return refuse(response, 415, "send JSON (Content-Type: application/json)");
  const json body = json::parse(request.body, nullptr, false);
  if (body.is_discarded()) return refuse(response, 400, "the request is not JSON");
  const Settings settings = parse_settings(body, options.scenes);
  if (!body.contains("client") || !body["client"].is_string()) throw InputError("\"client\" is missing");
  const std::string client = client_of(body["client"].get<std::string>());
  json key = body;
  key.erase("client");
  const auto comparison = hub.start(client, key.dump(), settings);
  response.status = 201;
  response.set_content(ordered_json{{"id", comparison->id()}}.dump(), kJson);
}

void Server::State::image(const Request& request, Response& response) {
  const auto comparison = hub.find(request.get_param_value("id"), request.get_param_value("client"));
  if (!comparison) return refuse(response, 404, "this comparison has ended: start it again");
  const std::string count = request.get_param_value("count");
  std::uint32_t n = 0;
  std::from_chars(count.data(), count.data() + count.size(), n);
  const auto image = comparison->image(request.get_param_value("sampler"), n);
  if (!image) return refuse(response, 404, "there is no such image (yet)");
  response.set_content(encoded(*image), "application/octet-stream");
}

void Server::State::routes() {
  http.set_pre_routing_handler([this](const Request& request, Response& response) {
    return refused(request, response) ? httplib::Server::HandlerResponse::Handled
                                      : httplib::Server::HandlerResponse::Unhandled;
  });
  const auto file = [this](const char* path, std::string_view text, const char* type) {
    http.Get(path, [text, type](const Request&, Response& response) {
      response.set_content(text.data(), text.size(), type);
    });
  };
  file("/", kPageHtml, "text/html; charset=utf-8");
  file("/page.css", kPageCss, "text/css; charset=utf-8");
  file("/page.js", kPageJs, "text/javascript; charset=utf-8");
  http.Get("/api/setup",
           [this](const Request&, Response& response) { response.set_content(setup().dump(), kJson); });
  http.Post("/api/start", [this](const Request& q, Response& r) { start(q, r); });
  http.Post("/api/leave", [this](const Request& q, Response& r) {
    hub.leave(client_of(q.get_param_value("client")));
    r.set_content("{}", kJson);
  });
  http.Get("/api/comparison", [this](const Request& q, Response& r) {
    const auto comparison = hub.find(q.get_param_value("id"), q.get_param_value("client"));
    if (!comparison) return refuse(r, 404, "this comparison has ended: start it again");
    r.set_content(comparison->snapshot().dump(), kJson);
  });
  http.Get("/api/image", [this](const Request& q, Response& r) { image(q, r); });
  http.set_exception_handler([](const Request&, Response& response, std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Busy& busy) {
      refuse(response, 429, busy.what());
    } catch (const InputError& error) {
      refuse(response, 400, error.what());
    } catch (const std::exception& error) {
      refuse(response, 500, one_line(error.what()));
    }
  });
  http.set_error_handler([](const Request&, Response& response) {
    if (!response.body.empty()) return;
    refuse(response, response.status,
           response.status == 413 ? "the request is too large" : "the request is not understood");
  });
}

Server::Server(ServerOptions options) : state_(std::make_unique<State>(std::move(options))) {
  State& s = *state_;
  s.limits();
  s.routes();
  if (s.options.port == 0) {
    s.port = s.http.bind_to_any_port("127.0.0.1");
  } else if (s.http.bind_to_port("127.0.0.1", s.options.port)) {
    s.port = s.options.port;
  }
  if (s.port <= 0)
    throw Failure(fmt::format("port {} of 127.0.0.1 cannot be had; name another, or --port 0 for a free one",
                              s.options.port));
}

Server::~Server() = default;
int Server::port() const {
  return state_->port;
}
void Server::run() {
  state_->http.listen_after_bind();
}
void Server::stop() {
  state_->http.stop();
}

}  // namespace capcon::serve
