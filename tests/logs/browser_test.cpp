#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "logs/report_html.h"
#include "logs/sweep_html.h"
#include "tests/logs/sample_page.h"
#include "tests/logs/sweep_of_two.h"
#include "tests/support/citrine_command.h"

namespace citrine::logs {
namespace {

/// Counts what a browser drew: figures with an area, words that reach out of their figure, whether the page
/// is wider than the window, pictures that did not load.
constexpr const char* kInspect = R"html(<script>
addEventListener("load", () => {
  let drawn = 0, outside = "";
  for (const svg of document.querySelectorAll("svg")) {
    const frame = svg.getBoundingClientRect();
    if (frame.width > 100 && frame.height > 20) ++drawn;
    for (const text of svg.querySelectorAll("text")) {
      const box = text.getBoundingClientRect();
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        outside += "[" + text.textContent + "]";
    }
  }
  const wide = document.documentElement.scrollWidth > innerWidth;
  const broken = [...document.images].filter(image => image.naturalWidth == 0).length;
  document.title = `drawn=${drawn} outside=${outside} wide=${wide} broken=${broken}`;
});
</script>)html";

/// What kInspect says of a page that is as it should be.
std::string Sound(const std::string& html) {
  int figures = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) ++figures;
  EXPECT_GT(figures, 1);
  return "drawn=" + std::to_string(figures) + " outside= wide=false broken=0";
}

class Browser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (RunCommandLine("command -v chromium").exit_code != 0) GTEST_SKIP() << "chromium is not installed";
  }

  /// The title that kInspect gives a page in a window of 1280 pixels, without any network.
  static std::string Inspect(const std::string& html) {
    const std::string file = ::testing::TempDir() + "/page.html";
    std::ofstream(file) << html << kInspect;
    const std::string dom =
        RunCommandLine(
            "unset DISPLAY; chromium --headless --no-sandbox --disable-gpu --no-first-run "
            "--disable-background-networking --disable-component-update --window-size=1280,2000 "
            "--user-data-dir=" +
            ::testing::TempDir() + "/profile --host-resolver-rules='MAP * ~NOTFOUND' --dump-dom file://" +
            file + " 2>/dev/null")
            .output;
    const std::size_t from = dom.find("<title>") + 7;
    return dom.substr(from, dom.find("</title>") - from);
  }
};

TEST_F(Browser, DrawsEveryFigureOfAReportWithItsWordsInside) {
  ReportPage page = SamplePage();
  page.topdown_png.clear();
  const std::string html = ReportHtml(page);
  EXPECT_EQ(Inspect(html), Sound(html));
}

TEST_F(Browser, DrawsEveryFigureOfASweepWithItsWordsInside) {
  const SweepResults results = SweepOfTwo();
  const std::string html = SweepHtml(results, SweepFigures(results));
  EXPECT_EQ(Inspect(html), Sound(html));
}

}  // namespace
}  // namespace citrine::logs
