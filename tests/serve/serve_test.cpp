// Requests, and the comparisons that they start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "cli/process.h"
#include "image/compare.h"
#include "serve/answer.h"
#include "serve/served.h"

namespace capcon {
namespace {

using nlohmann::json;
using testing::image_of;
using testing::Served;
using testing::small;
using testing::small_scene;
using testing::snapshot_when;

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
  const Image image = image_of(served, id, "random", shown["count"]);
  ASSERT_FALSE(image.pixels.empty());
  std::string command = shown["command"];
  const testing::Folder folder;
  ASSERT_TRUE(command.starts_with("capcon render"));
  command = command.substr(7, command.find(" -o ") - 7) + " -o " + (folder / "a.exr");
  ASSERT_EQ(testing::run(command).exit_code, 0) << command;
  EXPECT_EQ(compare(read_exr(folder / "a.exr"), image).max_difference, 0);
}

// Light paths are the page's test.
TEST(Serve, EqualSamplesAreEqualForOcclusionAndDirectLightWithAndWithoutSplits) {
  const testing::Folder folder;
  const Served served(15000, small_scene(folder));
  for (const auto& [integrator, split] : {std::pair("ao", 1), {"direct", 1}, {"direct", 4}}) {
    json body = small();
    body["integrator"] = integrator;
    body["split"] = split;
    body["mode"] = "equal-samples";
    body["frame_seconds"] = 0.01;
    if (integrator == std::string("direct")) body.erase("radius");
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

// How long the render would go on follows from the part that was done in the time until then.
TEST(Serve, ACancelledRenderEndsAtItsNextDispatchAndARestartHasTheSameBits) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const testing::Folder folder;
  const Served served(15000, small_scene(folder));
  const auto first_image = [&] {
    const std::string id = json::parse(served.start(small())->body).at("id");
    snapshot_when(served, id,
                  [](const json& s) { return s.contains("series") && s["series"][0].contains("shown"); });
    return image_of(served, id, "random", 1);
  };
  const Image before = first_image();
  ASSERT_FALSE(before.pixels.empty());
  json heavy = small();
  heavy.update({{"integrator", "igi"}, {"width", 640}, {"frame_seconds", 60}});
  heavy.erase("radius");
  const std::string id = json::parse(served.start(heavy)->body).at("id");
  double left = 0, part = 1;  // of the render under way: each takes longer than the one before
  auto at = Clock::now();
  const auto begun = at;
  while (left < 5 && seconds_since(begun) < 100) {
    const double now = snapshot_when(served, id, [&](const json& s) {
      return s.value("part", 0.0) > 0 && seconds_since(at) > 0.3;
    })["part"];
    left = now > part ? (1 - now) * seconds_since(at) / (now - part) : 0;
    part = now;
    at = Clock::now();
  }
  ASSERT_GE(left, 5) << "the setting is not heavy enough for this test";
  const auto cancelled = Clock::now();
  const Image after = first_image();
  EXPECT_LT(seconds_since(cancelled), left / 3);
  EXPECT_EQ(after.pixels, before.pixels);
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
  EXPECT_EQ(a["headline"], "Use one.");
  EXPECT_NEAR(a["time_ratio"]["two"]["value"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(a["error_ratio"]["two"]["value"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(a["error_ratio"]["two"]["low"].get<double>(), 2, 1e-9) << "what both have cancels out";
  const auto three = cells(1.01, 0.3), four = cells(1, -0.3);
  const json b = serve::answer({{"three", &three}, {"four", &four}}, 2, "device");
  EXPECT_EQ(b["decided"], false);
  EXPECT_THAT(b["text"].get<std::string>(), ::testing::HasSubstr("three errs "));
  EXPECT_EQ(b["headline"], "four or three: not decided yet.");
  const json c = serve::answer({{"one", &one}, {"two", &two}}, 100, "device");
  EXPECT_EQ(c["headline"], "Not known yet.");
  // One frame of a cell that is not at the frame time takes no interval away.
  auto five = cells(1, 0.01);
  five.front().frames.resize(1);
  five.back().frames.resize(1);
  const Interval most = serve::relmse_at({"one", &one}, 2), less = serve::relmse_at({"five", &five}, 2);
  EXPECT_NEAR(less.value, 0.5, 1e-9);
  EXPECT_NEAR(less.high, most.high, 1e-9);
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

}  // namespace
}  // namespace capcon
