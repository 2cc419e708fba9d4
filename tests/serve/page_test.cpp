// The page in a browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "browser/browser.h"
#include "cli/program.h"
#include "image/image.h"
#include "serve/served.h"

namespace capcon {
namespace {

using nlohmann::json;
using testing::Browser;
using testing::Served;
using testing::small_scene;

TEST(ServePage, LoadsRendersSwitchesSamplerAndWipes) {
  if (!Browser::available()) GTEST_SKIP() << "no /usr/bin/chromedriver and chromium";
  const char* pictures =
      std::getenv("CAPCON_PICTURES");  // a folder: the README's picture is taken, which takes longer
  const testing::Folder folder;
  // From the root of the sources: a picture shows no machine's folders.
  const Served served(15000, pictures ? "scenes/courtyard.pbrt" : small_scene(folder));
  Browser browser(1280, pictures ? 1240 : 1000);
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
        browser.wait_for("state.snapshot.answer.best && / by ([8-9]|[1-3][0-9]) seeds/.test("
                         "state.snapshot.answer.text)",
                         400));
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

// Light paths, and equal samples: both with what is copied, which is pasted and run.
TEST(ServePage, CopiesTheCommandLineOfWhatIsShown) {
  if (!Browser::available()) GTEST_SKIP() << "no /usr/bin/chromedriver and chromium";
  const testing::Folder folder;
  const Served served(15000, small_scene(folder));
  Browser browser(1280, 1000);
  browser.open(served.url());
  ASSERT_TRUE(browser.wait_for("document.querySelectorAll('#samplers input').length > 5"));
  browser.run(
      "$('width').append(new Option(16, 16)); $('width').value = 16; $('frame').value = 0.02; "
      "const paste = document.createElement('textarea'); paste.id = 'paste'; document.body.append(paste)");
  for (const auto& [integrator, mode] : {std::pair("igi", "equal-time"), {"ao", "equal-samples"}}) {
    browser.run(std::string("$('integrator').value = '") + integrator + "'; $('mode').value = '" + mode +
                "'; $('integrator').onchange()");
    browser.click("#start");
    ASSERT_TRUE(browser.wait_for(std::string("state.snapshot && state.images.has('random') && "
                                             "[...document.querySelectorAll('#table code')].every(c => ") +
                                     "/^capcon render .*--" +
                                     (mode == std::string("equal-time") ? "sets" : "radius") +
                                     "/.test(c.textContent))",
                                 120))
        << browser.run("return document.body.innerText");
    browser.click("#cancel");
    browser.click("#table button");
    browser.run("$('paste').value = ''");
    browser.keys("#paste", "\uE009v");  // control and v
    std::string command = browser.run("return $('paste').value");
    ASSERT_TRUE(command.starts_with("capcon render ")) << command;
    ASSERT_TRUE(command.ends_with("-o random.exr")) << command;
    command = command.substr(7, command.find(" -o ") - 7) + " -o " + (folder / "pasted.exr");
    ASSERT_EQ(testing::run(command).exit_code, 0) << command;
    const std::vector<float> shown = browser.run("return Array.from(state.images.get('random').data)");
    EXPECT_EQ(read_exr(folder / "pasted.exr").pixels, shown) << command;
  }
  EXPECT_THAT(browser.errors(), ::testing::IsEmpty());
}

}  // namespace
}  // namespace capcon
