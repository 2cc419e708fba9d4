#pragma once

#include <fcntl.h>
#include <httplib.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>

namespace capcon::testing {

/// Headless Chromium, driven by chromedriver's WebDriver protocol (https://www.w3.org/TR/webdriver2/). Heavy:
/// for one test file a program.
class Browser {
 public:
  static bool available() {
    return std::filesystem::exists("/usr/bin/chromedriver") && std::filesystem::exists("/usr/bin/chromium");
  }

  explicit Browser(int width = 1280, int height = 800, bool dark = false) {
    std::string pattern = (std::filesystem::temp_directory_path() / "capcon-browser-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    port_ = free_port();
    pid_ = ::fork();
    if (pid_ == 0) {
      ::setpgid(0, 0);
      const int log = ::open((folder_ / "log").c_str(), O_WRONLY | O_CREAT, 0600);
      ::dup2(log, 1);
      ::dup2(log, 2);
      ::execl("/usr/bin/chromedriver", "chromedriver", ("--port=" + std::to_string(port_)).c_str(), nullptr);
      ::_exit(127);
    }
    const nlohmann::json arguments = {
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--user-data-dir=" + (folder_ / "profile").string(),
        "--window-size=" + std::to_string(width) + "," + std::to_string(height),
        dark ? "--blink-settings=preferredColorScheme=0" : "--blink-settings=preferredColorScheme=1"};
    const nlohmann::json wanted = {
        {"capabilities",
         {{"alwaysMatch",
           {{"goog:chromeOptions", {{"args", arguments}, {"binary", "/usr/bin/chromium"}}},
            {"goog:loggingPrefs", {{"browser", "ALL"}}}}}}}};
    for (int tries = 0; tries < 2400; ++tries) {  // until it listens
      if (httplib::Client("127.0.0.1", port_).Get("/status")) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    session_ = "/session/" + post("/session", wanted).at("sessionId").get<std::string>();
  }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  ~Browser() {
    if (!session_.empty()) httplib::Client("127.0.0.1", port_).Delete(session_);
    ::kill(-pid_, SIGTERM);  // our own process group
    ::waitpid(pid_, nullptr, 0);
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  void open(const std::string& url) { post(session_ + "/url", {{"url", url}}); }
  /// What "return ..." returns.
  nlohmann::json run(const std::string& script) {
    return post(session_ + "/execute/sync", {{"script", script}, {"args", nlohmann::json::array()}});
  }
  /// Whether the expression becomes true in time.
  bool wait_for(const std::string& expression, double seconds = 60) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < until) {
      if (run("return !!(" + expression + ")") == true) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(40));
    }
    return false;
  }
  void click(const std::string& css) { post(element(css) + "/click", nlohmann::json::object()); }
  void keys(const std::string& css, const std::string& text) {
    post(element(css) + "/value", {{"text", text}});
  }
  void resize(int width, int height) {
    post(session_ + "/window/rect", {{"width", width}, {"height", height}});
  }
  void screenshot(const std::string& file) {
    const std::string base64 = get(session_ + "/screenshot").get<std::string>();
    std::ofstream out(file, std::ios::binary);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : base64) {
      static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      const auto value = letters.find(c);
      if (value == std::string::npos) continue;
      bits = bits << 6 | static_cast<std::uint32_t>(value);
      if ((held += 6) >= 8) out.put(static_cast<char>(bits >> (held -= 8) & 255));
    }
  }
  /// Errors of the console since the last call.
  std::vector<std::string> errors() {
    std::vector<std::string> found;
    for (const auto& entry : post(session_ + "/se/log", {{"type", "browser"}}))
      if (entry.value("level", "") == "SEVERE") found.push_back(entry.value("message", ""));
    return found;
  }

 private:
  /// One that nobody listens at now (httplib's server would keep it).
  static int free_port() {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ::bind(socket, reinterpret_cast<sockaddr*>(&address), size);
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    ::close(socket);
    return ntohs(address.sin_port);
  }
  std::string element(const std::string& css) {
    return session_ + "/element/" +
           post(session_ + "/element", {{"using", "css selector"}, {"value", css}})
               .begin()
               .value()
               .get<std::string>();
  }
  static nlohmann::json value_of(const httplib::Result& result, const std::string& path) {
    if (!result) throw std::runtime_error("chromedriver does not answer " + path);
    nlohmann::json value = nlohmann::json::parse(result->body).at("value");
    if (result->status != 200) throw std::runtime_error(path + ": " + value.dump());
    return value;
  }
  nlohmann::json post(const std::string& path, const nlohmann::json& body) {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(120);
    return value_of(client.Post(path, body.dump(), "application/json"), path);
  }
  nlohmann::json get(const std::string& path) {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(120);
    return value_of(client.Get(path), path);
  }

  std::filesystem::path folder_;
  int port_ = 0;
  pid_t pid_ = 0;
  std::string session_;
};

}  // namespace capcon::testing
