#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "chromium.h"
#include "fake_device.h"
#include "folder.h"
#include "study/embedded.h"
#include "study/study.h"

namespace capcon {
namespace {

/// What a user does with the page, and what it answers; put into the page, before all else and behind it.
constexpr const char* kListen = R"(<script>
window.complaints = [];
addEventListener('error', (e) => complaints.push(String(e.message)));
addEventListener('unhandledrejection', (e) => complaints.push(String(e.reason)));
console.error = console.warn = (...all) => complaints.push(all.join(' '));
addEventListener('securitypolicyviolation', (e) => complaints.push('refused: ' + e.blockedURI));
</script>)";

constexpr const char* kUse = R"(<script>
(async () => {
  const r = {};
  const until = async (test) => {
    for (let i = 0; i < 200 && !test(); ++i) await new Promise((done) => setTimeout(done, 20));
    return test();
  };
  const mouse = (target, type, x, y) => target.dispatchEvent(new MouseEvent(type, {
    bubbles: true, cancelable: true, view: window, clientX: x, clientY: y, button: 0, detail: 1}));
  const pointer = (target, type, x, y) => target.dispatchEvent(new PointerEvent(type, {
    bubbles: true, cancelable: true, clientX: x, clientY: y, pointerId: 1}));
  const key = (target, name, more) => target.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true, ...more}));
  try {
    await until(() => document.querySelector('.viewer canvas'));
    // Charts
    const boxes = [...document.querySelectorAll('.live')];
    r.charts = boxes.length;
    r.stills = [...document.querySelectorAll('.still')].filter((e) => getComputedStyle(e).display !== 'none').length;
    if (boxes.length) {
      const box = boxes[0], g = box.chart, plot = box.querySelector('.canvas'), tip = box.querySelector('.tip');
      box.scrollIntoView();
      r.home = [...g.xAxisRange(), ...g.yAxisRange()];
      const area = g.getArea(), canvas = [...plot.querySelectorAll('canvas')].pop(), at = canvas.getBoundingClientRect();
      const place = (x, y) => [at.left + area.x + g.toPercentXCoord(x) * area.w, at.top + g.toDomYCoord(y)];
      const point = JSON.parse(box.parentNode.querySelector('script').textContent).lines[3].points[4];
      const [px, py] = place(point[0], point[3]);
      mouse(canvas, 'mousemove', px + 2, py - 2);
      r.point = point[7];
      r.hover = tip.hidden ? '' : tip.textContent;
      const drag = (fx, tx, fy, ty) => {
        mouse(canvas, 'mousedown', at.left + area.x + fx * area.w, at.top + area.y + fy * area.h);
        for (const [x, y] of [[(fx + tx) / 2, (fy + ty) / 2], [tx, ty]])
          mouse(document, 'mousemove', at.left + area.x + x * area.w, at.top + area.y + y * area.h);
        mouse(document, 'mouseup', at.left + area.x + tx * area.w, at.top + area.y + ty * area.h);
      };
      drag(0.25, 0.5, 0.5, 0.5);
      r.zoomed = g.xAxisRange();
      const whole = box.querySelector('.whole');
      r.offersReset = !whole.hidden;
      for (const type of ['mousedown', 'mouseup', 'mousedown', 'mouseup'])
        mouse(type === 'mouseup' ? document : canvas, type, at.left + 200, at.top + 100);
      mouse(canvas, 'dblclick', at.left + 200, at.top + 100);
      r.reset = [...g.xAxisRange(), ...g.yAxisRange()];
      plot.focus();
      key(plot, '+');
      r.byKey = g.xAxisRange();
      key(plot, '0');
      r.back = g.xAxisRange();
      key(plot, 'ArrowRight');
      key(plot, 'ArrowLeft');
      r.spoken = tip.textContent;
      const button = box.querySelectorAll('.legend button[aria-pressed]')[1];
      button.click();
      r.hidden = [g.visibility()[1], button.getAttribute('aria-pressed')];
      button.click();
      r.shown = g.visibility()[1];
    }
    // Images
    const stage = document.querySelector('.stage'), canvas = stage.querySelector('canvas');
    stage.scrollIntoView();
    await until(() => canvas.width > 300);
    const colour = (x, y) => [...canvas.getContext('2d').getImageData(x * canvas.width, y * canvas.height, 1, 1).data];
    const [wipe, exposure] = document.querySelectorAll('.controls input');
    const set = (input, value) => {
      input.value = value;
      input.dispatchEvent(new Event('input'));
    };
    const column = () => Array.from({length: 20}, (_, i) => colour(0.3, (i + 0.5) / 20)[0]).join();
    set(wipe, 0);
    r.right = column();
    set(wipe, 1);
    r.left = column();
    const box = canvas.getBoundingClientRect();
    pointer(canvas, 'pointermove', box.left + 0.3 * box.width, box.top + 0.4 * box.height);
    r.readout = document.querySelector('.readout').textContent;
    r.place = [0.3, 0.4];
    canvas.setPointerCapture = () => {};  // made-up pointers cannot be caught
    pointer(canvas, 'pointerdown', box.left + 0.9 * box.width, box.top + 10);
    pointer(canvas, 'pointermove', box.left + 0.2 * box.width, box.top + 10);
    pointer(canvas, 'pointerup', box.left + 0.2 * box.width, box.top + 10);
    r.wiped = Number(wipe.value);
    set(wipe, 1);
    set(exposure, 2);
    r.exposed = column();
    set(exposure, 0);
    document.querySelector('.controls button[aria-pressed]').click();
    r.falseColour = column();
    r.scale = document.querySelector('.scale').textContent;
    canvas.focus();
    key(canvas, 'ArrowRight');
    const before = document.querySelector('.readout').textContent;
    key(canvas, 'ArrowRight');
    r.moved = before !== document.querySelector('.readout').textContent;
    // Data
    const link = document.querySelector('a[download="runs.csv"]');
    r.runs = (await (await new Response(decodeURIComponent(link.href.split('utf-8,')[1])).text())).trim().split('\n').length;
    let blob;
    URL.createObjectURL = (b) => (blob = b, '#');
    HTMLAnchorElement.prototype.click = () => {};
    document.querySelector('button[data-download]').click();
    r.json = JSON.parse(await blob.text()).curves.length;
    r.unlabelled = [...document.querySelectorAll('input,select,button')].filter(
      (e) => e.offsetParent && !(e.labels?.length || e.textContent.trim() || e.getAttribute('aria-label'))).length;
  } catch (error) {
    complaints.push(String(error.stack));
  }
  r.complaints = complaints;
  document.documentElement.setAttribute('data-result', btoa(unescape(encodeURIComponent(JSON.stringify(r)))));
})();
</script>)";

std::string from_base64(const std::string& text) {
  static const std::string kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    word = word << 6 | static_cast<unsigned>(kAlphabet.find(c));
    if ((bits += 6) >= 8) bytes += static_cast<char>(word >> (bits -= 8) & 255);
  }
  return bytes;
}

class ReportInABrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_chromium()) GTEST_SKIP() << "chromium is not installed";
    settings_ = fake_settings();
    settings_.close_ups = true;
    settings_.seeds = 3;
    RunnerOptions options;
    options.directory = folder_;
    options.quiet = true;
    report_ = study_report(settings_, fake_device(), options);
    html_ = read_file(folder_ / "report.html");
  }

  const Folder folder_;
  StudySettings settings_;
  StudyReport report_;
  std::string html_;
};

TEST_F(ReportInABrowser, AnswersToPointerAndKeys) {
  std::string page = html_;
  page.insert(page.find("<head>") + 6, kListen);
  page.insert(page.find("</body>"), kUse);
  write_file(folder_ / "used.html", page);
  const std::string dom = chromium(folder_, folder_ / "used.html", "--window-size=1280,900 --dump-dom");
  const std::size_t at = dom.find("data-result=\"");
  ASSERT_NE(at, std::string::npos) << dom.substr(0, 300);
  const auto r = nlohmann::json::parse(from_base64(dom.substr(at + 13, dom.find('"', at + 13) - at - 13)));
  SCOPED_TRACE(r.dump(1));
  EXPECT_TRUE(r.at("complaints").empty());
  if (!embedded::dygraphs().empty()) {
    EXPECT_EQ(r.at("charts"), 4);
    EXPECT_EQ(r.at("stills"), 0);
    EXPECT_EQ(r.at("hover").get<std::string>().find(r.at("point").get<std::string>()), 0u);
    EXPECT_NE(r.at("hover").get<std::string>().find("95 %: "), std::string::npos);
    // A quarter of a logarithmic axis, from its first quarter on.
    const double low = r["home"][0], high = r["home"][1];
    EXPECT_NEAR(r["zoomed"][0].get<double>(), low * std::pow(high / low, 0.25), 0.05 * low);
    EXPECT_NEAR(r["zoomed"][1].get<double>(), low * std::pow(high / low, 0.5), 0.05 * high);
    EXPECT_EQ(r.at("offersReset"), true);
    EXPECT_EQ(r.at("reset"), r.at("home"));
    EXPECT_GT(r["byKey"][0].get<double>(), low);
    EXPECT_LT(r["byKey"][1].get<double>(), high);
    EXPECT_EQ(r["back"][0], r["home"][0]);
    EXPECT_NE(r.at("spoken").get<std::string>().find("capcon at "), std::string::npos);
    EXPECT_EQ(r.at("hidden"), nlohmann::json({false, "false"}));
    EXPECT_EQ(r.at("shown"), true);
  }
  EXPECT_NE(r.at("left"), r.at("right"));
  EXPECT_NE(r.at("left"), r.at("exposed"));
  EXPECT_NE(r.at("left"), r.at("falseColour"));
  EXPECT_NEAR(r.at("wiped").get<double>(), 0.2, 0.011);
  EXPECT_NE(r.at("scale").get<std::string>().find("and above"), std::string::npos);
  EXPECT_EQ(r.at("moved"), true);
  EXPECT_EQ(r.at("runs"), 1 + report_.result.records.size());
  EXPECT_EQ(r.at("json"), settings_.samplers.size());
  EXPECT_EQ(r.at("unlabelled"), 0);
  // The value under the cursor is that of the image, to the digits shown.
  const auto facts = nlohmann::json::parse(read_file(folder_ / "close-ups/close-ups.json"));
  const Image picture = read_exr(folder_ / "close-ups/picture.exr");
  const auto region = facts.at("region").get<std::vector<int>>();
  const int x = region[0] + static_cast<int>(0.3 * region[2]),
            y = region[1] + static_cast<int>(0.4 * region[3]);
  const auto readout = r.at("readout").get<std::string>();
  EXPECT_EQ(readout.find(fmt::format("pixel {}, {}: ", x, y)), 0u) << readout;
  const double shown = std::stod(readout.substr(readout.find("reference ") + 10));
  EXPECT_NEAR(shown, picture.at(x, y, 0), 1e-3);
}

TEST_F(ReportInABrowser, IsWholeWithoutScripts) {
  // A browser that is told to run none, as one that has them switched off.
  std::string page = html_;
  const std::string allowed = "script-src 'unsafe-inline'";
  page.replace(page.find(allowed), allowed.size(), "script-src 'none'");
  write_file(folder_ / "still.html", page);
  const std::string dom = chromium(folder_, folder_ / "still.html", "--dump-dom");
  ASSERT_NE(dom.find("</html>"), std::string::npos);
  EXPECT_EQ(dom.find("plot is-live"), std::string::npos);
  EXPECT_EQ(dom.find("<canvas"), std::string::npos);
  EXPECT_NE(dom.find("<svg class=\"chart\""), std::string::npos);
  EXPECT_NE(dom.find("<div class=\"viewer\" hidden"), std::string::npos);
  EXPECT_NE(dom.find("download=\"runs.csv\""), std::string::npos);
}

// Not a test of anything: with CAPCON_PICTURES=DIR the README's picture, of the main job's report, is written
// there.
TEST(ReportPictures, AreTakenForTheReadme) {
  const char* to = std::getenv("CAPCON_PICTURES");
  if (!to) GTEST_SKIP() << "set CAPCON_PICTURES=DIR to take the README's pictures (two minutes)";
  if (!has_chromium()) GTEST_SKIP() << "chromium is not installed";
  const std::filesystem::path folder = std::filesystem::absolute(to);
  std::filesystem::create_directories(folder);
  const std::string command = fmt::format("'{}' study ambient-occlusion -o '{}' >/dev/null", CAPCON_PROGRAM,
                                          (folder / "study").string());
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto take = [&](const std::string& page, const std::string& size, const std::string& name) {
    chromium(folder, folder / page,
             fmt::format("--window-size={} --screenshot='{}'", size, (folder / name).string()));
    EXPECT_GT(std::filesystem::file_size(folder / name), 50'000u);
  };
  take("study/report.html", "1240,1500", "report.png");
  std::string html = read_file(folder / "study/report.html");
  html.insert(html.find("</head>"), "<style>header,section:not(#close-ups){display:none}</style>");
  write_file(folder / "images.html", html);
  take("images.html", "1240,1330", "report-images.png");
}

}  // namespace
}  // namespace capcon
