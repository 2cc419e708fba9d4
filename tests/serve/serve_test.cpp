#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
#include <thread>

#include "browser/browser.h"
#include "cli/process.h"
#include "image/compare.h"
#include "serve/answer.h"
#include "serve/server.h"

namespace capcon {
namespace {

using nlohmann::json;
using testing::Browser;

const std::string kScene = CAPCON_SOURCE_DIR "/scenes/courtyard.pbrt";

/// Lamp, floor and ball: what is held of it is small beside what a leak would add up to.
std::string small_scene(const testing::Folder& folder) {
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

json small(const std::string& client = "me") {
  return {{"client", client},
          {"samplers", {"random", "sobol-owen"}},
          {"width", 32},
          {"frame_seconds", 0.02},
          {"radius", 2}};
}

json snapshot_when(const Served& served, const std::string& id,
                   const std::function<bool(const json&)>& there) {
  json s;
  for (int i = 0; i < 6000; ++i) {
    s = json::parse(served.client().Get("/api/comparison?client=me&id=" + id)->body);
    if (there(s) || s.value("state", "") == "failed") return s;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return s;
}

TEST(Serve, PagesAndSetupAreThere) {
  const Served served;
  for (const char* path : {"/", "/page.css", "/page.js"})
    EXPECT_EQ(served.client().Get(path)->status, 200) << path;
  const json setup = json::parse(served.client().Get("/api/setup")->body);
  EXPECT_EQ(setup["scenes"][0], "courtyard");
  EXPECT_EQ(setup["devices"][0], "lavapipe");
}

TEST(Serve, WrongRequestsAreRefusedWithASentence) {
  const Served served;
  const auto status = [&](const httplib::Result& r) {
    if (r && r->status >= 400) {
      EXPECT_FALSE(json::parse(r->body).value("error", "").empty()) << r->body;
    }
    return r ? r->status : 0;
  };
  for (const char* path :
       {"/nothing", "/../CMakeLists.txt", "/page/../../x", "/%2e%2e/%2e%2e/etc/passwd", "/etc/passwd"})
    EXPECT_EQ(status(served.client().Get(path)), 404) << path;
  EXPECT_EQ(status(served.client().Post("/", "", "text/plain")), 405);
  EXPECT_EQ(status(served.client().Get("/api/start")), 405);
  EXPECT_EQ(status(served.client().Post("/api/start", "{}", "text/plain")), 415);
  EXPECT_EQ(status(served.client().Post("/api/start", "{nonsense", "application/json")), 400);
  EXPECT_EQ(status(served.client().Post("/api/start", std::string(20000, ' '), "application/json")), 413);
  const std::vector<std::pair<const char*, json>> wrong = {{"scene", "../../etc/passwd"},
                                                           {"scene", 3},
                                                           {"samplers", {"random"}},
                                                           {"samplers", {"random", "random"}},
                                                           {"samplers", {"random", "nobody"}},
                                                           {"width", 100000},
                                                           {"width", 32.5},
                                                           {"split", 3},
                                                           {"radius", -1},
                                                           {"client", "a b"},
                                                           {"unknown", 1},
                                                           {"mode", "fast"},
                                                           {"frame_seconds", "2"}};
  for (const auto& [key, value] : wrong) {
    json body = small();
    body[key] = value;
    EXPECT_EQ(status(served.start(body)), 400) << key << " " << value;
  }
  for (const char* path : {"/api/comparison?id=9", "/api/image?id=9&sampler=random&count=1"})
    EXPECT_EQ(status(served.client().Get(path)), 404);
}

TEST(Serve, OtherHostsAndOriginsAreRefused) {
  const Served served;
  const auto get = [&](const httplib::Headers& headers) {
    return served.client().Get("/api/setup", headers)->status;
  };
  for (const char* host : {"127.0.0.1", "localhost:9000", "127.0.0.1:1", "[::1]:8080"})
    EXPECT_EQ(get({{"Host", host}}), 200) << host;
  for (const char* host :
       {"evil.example", "127.0.0.1.evil.example", "localhost.evil.example:80", "localhost:x", ""})
    EXPECT_EQ(get({{"Host", host}}), 403) << host;
  EXPECT_EQ(get({{"Origin", "http://localhost:1234"}}), 200);
  for (const char* origin :
       {"http://evil.example", "null", "https://127.0.0.1.evil.example", "http://localhost@evil.example"})
    EXPECT_EQ(get({{"Origin", origin}}), 403) << origin;
}

TEST(Serve, TheCommandLineShownMakesTheSameBits) {
  const testing::Folder scenes;
  const Served served(15000, small_scene(scenes));
  const std::string id = json::parse(served.start(small())->body).at("id");
  const json s = snapshot_when(served, id, [](const json& s) {
    return s.contains("series") && s["series"][0].value("frames", 0) > 8;
  });
  ASSERT_TRUE(s["series"][0].contains("shown")) << s.dump(1);
  const json& shown = s["series"][0]["shown"];
  const auto r = served.client().Get("/api/image?client=me&id=" + id +
                                     "&sampler=random&count=" + std::to_string(shown["count"].get<int>()));
  ASSERT_EQ(r->status, 200);
  std::uint32_t head[3];
  std::memcpy(head, r->body.data(), sizeof head);
  const auto [width, height, channels] = head;
  Image image{static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels)};
  ASSERT_EQ(r->body.size(), 12 + image.pixels.size() * 4);
  std::memcpy(image.pixels.data(), r->body.data() + 12, image.pixels.size() * 4);
  std::string command = shown["command"];
  const testing::Folder folder;
  ASSERT_TRUE(command.starts_with("capcon render"));
  command = command.substr(7, command.find(" -o ") - 7) + " -o " + (folder / "a.exr");
  ASSERT_EQ(testing::run(command).exit_code, 0) << command;
  EXPECT_EQ(compare(read_exr(folder / "a.exr"), image).max_difference, 0);
}

// With equal samples. (Light paths take long to compile and have no test of their own here.)
TEST(Serve, DirectLightIsComparedWithAndWithoutSplits) {
  const testing::Folder folder;
  const Served served(15000, small_scene(folder));
  for (const auto& [integrator, split] : {std::pair("direct", 1), {"direct", 4}}) {
    json body = small();
    body["integrator"] = integrator;
    body["split"] = split;
    body["mode"] = "equal-samples";
    body["frame_seconds"] = 0.01;
    body.erase("radius");
    const auto started = served.start(body);
    ASSERT_EQ(started->status, 201) << integrator << ": " << started->body;
    const std::string id = json::parse(started->body).at("id");
    const json s = snapshot_when(served, id, [](const json& s) {
      return s.contains("series") && s["series"][0].value("frames", 0) > 1 &&
             s["series"][1].value("frames", 0) > 1;
    });
    ASSERT_NE(s.value("state", ""), "failed") << integrator << ": " << s.dump(1);
    const int apart = s["series"][0].value("frames", 0) - s["series"][1].value("frames", 0);
    EXPECT_LE(std::abs(apart), 1) << integrator << ": equal samples";
    EXPECT_THAT(s["series"][0]["shown"].value("command", ""), ::testing::HasSubstr("capcon render"));
  }
}

TEST(Serve, TenClientsAtOnceAndABoundedNumberOfComparisons) {
  const Served served;
  std::set<std::string> ids;
  std::mutex mutex;
  {
    std::vector<std::jthread> clients;
    for (int i = 0; i < 10; ++i) {
      clients.emplace_back([&, i] {
        const std::string name = "c" + std::to_string(i);
        const json started = json::parse(served.start(small(name))->body);
        for (int k = 0; k < 10; ++k)
          EXPECT_EQ(served.client()
                        .Get("/api/comparison?client=" + name + "&id=" + started.value("id", ""))
                        ->status,
                    200);
        const std::lock_guard lock(mutex);
        ids.insert(started.value("id", ""));
      });
    }
  }
  EXPECT_EQ(ids.size(), 1u);  // equal settings: one comparison
  for (int i = 0; i < 4; ++i) {
    json body = small("other" + std::to_string(i));
    body["width"] = 33 + i;
    EXPECT_EQ(served.start(body)->status, i < 3 ? 201 : 429);
  }
}

TEST(Serve, AComparisonThatNobodyLooksAtIsDropped) {
  const Served served(200);
  const std::string id = json::parse(served.start(small())->body).at("id");
  int status = 200;
  for (int i = 0; i < 100 && status == 200; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    status = served.client().Get("/api/comparison?client=stranger&id=" + id)->status;
  }
  EXPECT_EQ(status, 404);
}

/// Threads, open files and resident pages of this process.
std::array<long, 3> held() {
  const auto entries = [](const char* folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
  };
  long size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return {entries("/proc/self/task"), entries("/proc/self/fd"), resident};
}

TEST(Serve, HoldsNothingAfterManyStartsAndCancels) {
  const testing::Folder folder;
  const Served served(15000, small_scene(folder));
  const auto turn = [&](int i) {
    json body = small();
    body["width"] = 16 + i % 20;
    ASSERT_EQ(served.start(body)->status, 201);
    served.client().Get("/page.js");
    if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(60));
    ASSERT_EQ(served.client().Post("/api/leave?client=me")->status, 200);
  };
  const auto settled = [] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    ::malloc_trim(0);  // what the heap keeps for later is no leak
    return held();
  };
  for (int i = 0; i < 40; ++i) turn(i);
  const auto first = settled();
  // What is kept once (a device's caches, heaps of threads) comes some time; a leak grows in every window.
  long least = std::numeric_limits<long>::max(), before = first[2];
  auto last = first;
  for (int window = 0; window < 3; ++window) {
    for (int i = 0; i < 80; ++i) turn(i);
    last = settled();
    least = std::min(least, last[2] - before);
    before = last[2];
  }
  EXPECT_LE(last[0], first[0] + 4);
  EXPECT_LE(last[1], first[1] + 8);
  EXPECT_LE(least, 6 * 256) << "pages of 4 KiB: 6 MiB";
}

TEST(Serve, SaysWhatIsDecidedAndWhatIsNot) {
  // Frames with errors a / seconds, and two curves of which one needs twice the time of the other.
  const auto cells = [](double a, double spread) {
    std::vector<serve::Cell> cells;
    for (const double t : {0.5, 1.0, 2.0, 4.0, 8.0}) {
      serve::Cell cell;
      for (int i = 0; i < 8; ++i) cell.frames.push_back({t, 0, a / t * (1 + spread * (i % 2 ? 1 : -1)), 1});
      cells.push_back(cell);
    }
    return cells;
  };
  const auto one = cells(1, 0.01), two = cells(2, 0.01);
  const json a = serve::answer({{"one", &one}, {"two", &two}}, 2, "device");
  EXPECT_EQ(a["best"], "one");
  EXPECT_EQ(a["decided"], true);
  EXPECT_NEAR(a["time_ratio"]["two"]["value"].get<double>(), 2, 1e-9);
  EXPECT_LT(a["time_ratio"]["two"]["low"].get<double>(), 2);
  const auto three = cells(1.01, 0.3), four = cells(1, 0.3);
  const json b = serve::answer({{"three", &three}, {"four", &four}}, 2, "device");
  EXPECT_EQ(b["decided"], false);
  EXPECT_THAT(b["text"].get<std::string>(), ::testing::HasSubstr("Not decided beside three"));
  const json c = serve::answer({{"one", &one}, {"two", &two}}, 100, "device");
  EXPECT_THAT(c["text"].get<std::string>(), ::testing::HasSubstr("not known yet"));
}

TEST(ServeVerb, SaysItsAddressAndThatAPortIsTaken) {
  const Served served;
  const auto taken = testing::run("serve --port " + std::to_string(served.port()));
  EXPECT_EQ(taken.exit_code, 1);
  EXPECT_THAT(taken.err, ::testing::HasSubstr("cannot be had"));
  testing::Process process("serve --port 0 --json");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto end = process.end(SIGINT);
  EXPECT_EQ(end.exit_code, 130);
  EXPECT_THAT(json::parse(end.out).at("url").get<std::string>(), ::testing::StartsWith("http://127.0.0.1:"));
}

TEST(ServePage, LoadsRendersSwitchesSamplerAndWipes) {
  if (!Browser::available()) GTEST_SKIP() << "no /usr/bin/chromedriver and chromium";
  const char* pictures =
      std::getenv("CAPCON_PICTURES");  // a folder: the README's picture is taken, which takes longer
  const testing::Folder folder;
  const Served served(15000, pictures ? kScene : small_scene(folder));
  Browser browser(1280, 1000);
  browser.open(served.url());
  ASSERT_TRUE(browser.wait_for("document.querySelectorAll('#samplers input').length > 5"));
  if (!pictures) {
    browser.run(
        "document.getElementById('width').value = '120'; document.getElementById('frame').value = '0.05'");
    browser.click("#start");
  }
  ASSERT_TRUE(browser.wait_for("document.getElementById('view').dataset.drawn", 120))
      << browser.run("return document.body.innerText");
  ASSERT_TRUE(browser.wait_for("document.querySelectorAll('#chart circle').length >= 6", 120));
  if (pictures) {
    EXPECT_TRUE(
        browser.wait_for("/^At/.test(document.getElementById('answer').textContent) && !/not "
                         "known/.test(document.getElementById('answer').textContent) && "
                         "state.snapshot.series.every(s => s.cells.at(-1).seeds >= 2)",
                         300));
    browser.run(
        "document.getElementById('left').value = 'random'; document.getElementById('right').value = "
        "'capcon-domain'; fetchImages()");
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    browser.screenshot(std::string(pictures) + "/serve.png");
  } else {
    EXPECT_TRUE(
        browser.wait_for("document.querySelector('#table code').textContent.startsWith('capcon render ')"));
  }
  const auto seen = [&] {  // a checksum of what the canvas shows
    return browser.run(
        "const v = document.getElementById('view'); return v.getContext('2d').getImageData(0, 0, v.width, "
        "v.height).data.reduce((sum, x) => (sum * 31 + x) >>> 0, 7)");
  };
  const json before = seen();
  browser.run("const w = document.getElementById('wipe'); w.value = 5; w.oninput()");
  EXPECT_NE(seen(), before);  // the right image is there now
  // Exposure, false colour and zoom change what is seen; the value under the cursor does not depend on them.
  const auto value_at_middle = [&] {
    browser.run(
        "const v = document.getElementById('view'), r = v.getBoundingClientRect(); v.dispatchEvent(new "
        "PointerEvent('pointermove', {clientX: r.left + r.width / 2, clientY: r.top + r.height / 2, bubbles: "
        "true}))");
    return browser.run("return document.getElementById('value').textContent").get<std::string>();
  };
  const std::string value = value_at_middle();
  EXPECT_THAT(value, ::testing::ContainsRegex("[0-9]"));
  for (const char* change :
       {"const e = document.getElementById('exposure'); e.value = -2; e.oninput()",
        "const e = document.getElementById('error'); e.checked = true; e.oninput()",
        "const e = document.getElementById('error'); e.checked = false; e.oninput(); const z = "
        "document.getElementById('zoom'); z.value = 4; z.oninput()"}) {
    const json last = seen();
    browser.run(change);
    EXPECT_NE(seen(), last) << change;
  }
  browser.run(
      "const z = document.getElementById('zoom'); z.value = 1; z.oninput(); const e = "
      "document.getElementById('exposure'); e.value = 0; e.oninput()");
  EXPECT_EQ(value_at_middle(), value);
  browser.run("document.getElementById('view').focus()");
  browser.keys("#view", "\uE014");  // the right arrow
  EXPECT_EQ(browser.run("return +document.getElementById('wipe').value"), 7);
  browser.run("const l = document.getElementById('left'); l.value = 'reference'; l.onchange()");
  EXPECT_TRUE(browser.wait_for("document.getElementById('view').dataset.drawn.startsWith('reference,')"));
  browser.click("#samplers input[value=halton]");
  browser.click("#start");
  EXPECT_TRUE(browser.wait_for(
      "[...document.querySelectorAll('#table td')].some(c => c.textContent === 'halton')", 120));
  EXPECT_TRUE(browser.wait_for(
      "state.snapshot.series.length === 4 && document.querySelectorAll('#chart circle').length >= 4", 120));
  browser.click("#cancel");
  EXPECT_TRUE(browser.wait_for("document.getElementById('status').textContent === 'Stopped.'"));
  browser.resize(500, 900);
  EXPECT_EQ(browser.run("return document.documentElement.scrollWidth <= innerWidth"), true);
  EXPECT_THAT(browser.errors(), ::testing::IsEmpty());
}

}  // namespace
}  // namespace capcon
