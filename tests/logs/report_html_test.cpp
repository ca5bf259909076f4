#include "logs/report_html.h"

#include <cctype>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "logs/html_text.h"
#include "logs/svg_chart.h"
#include "tests/logs/sample_page.h"

namespace citrine::logs {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The innermost tag left open or closed wrongly; empty if every tag has its end.
std::string Unbalanced(const std::string& html) {
  const std::set<std::string> kVoid = {"!DOCTYPE"};
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "unfinished tag";
    const std::string tag = html.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return "tag within tag: " + tag;
    const bool closing = tag[0] == '/';
    std::string name;
    for (std::size_t k = closing; k < tag.size() && (std::isalnum(tag[k]) || tag[k] == '!'); ++k)
      name += tag[k];
    if (kVoid.count(name) > 0 || tag.back() == '/') continue;
    if (!closing) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + ">";
}

TEST(ReportHtml, OpensWithoutANetwork) {
  const std::string html = ReportHtml(SamplePage());
  for (const char* reference : {"http:", "https:", "//", "<link", "<script", "@import", "url("})
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,AQIDBA==\""));
}

TEST(ReportHtml, ClosesEveryTagItOpens) { EXPECT_EQ(Unbalanced(ReportHtml(SamplePage())), ""); }

TEST(ReportHtml, SaysTheVerdictTheNumbersAndHowToFlyItAgain) {
  const std::string html = ReportHtml(SamplePage());
  EXPECT_THAT(html, HasSubstr("Surface complete after 2:00, no collision"));
  EXPECT_THAT(html, HasSubstr("79.90"));
  EXPECT_THAT(html, HasSubstr("80.73"));       // the paper's coverage of House
  EXPECT_THAT(html, Not(HasSubstr("95.48")));  // and not that of Structure
  EXPECT_THAT(html, HasSubstr("--set planner.gamma=2"));
  EXPECT_THAT(html, HasSubstr("a &lt;b&gt; &amp; &#39;c&#39;"));
  EXPECT_THAT(html, HasSubstr("UAV*_STATE"));
}

TEST(ReportHtml, DrawsWhatChangedOverTheMission) {
  const std::string html = ReportHtml(SamplePage());
  for (const char* title : {"True surface seen from within d*", "Active elements", "Paths from above",
                            "Goals chosen", "Imbalance corrections", "Said on the bus", "Computing time"})
    EXPECT_THAT(html, HasSubstr(std::string("<figcaption>") + title));
  // Corrections at 0, 20, 40, 60 and 80 of 120 s rise by one each: of an axis of 5 over 188 pixels.
  EXPECT_THAT(html, HasSubstr("54.0,162.4 106.5,162.4 106.5,124.8 "));
}

TEST(ReportHtml, PlotsTheFlightOfEveryUavOverTime) {
  ReportPage page = SamplePage();
  const std::string without_world = ReportHtml(page);
  for (const char* title : {"Speed", "Acceleration, mean over 0.1 s", "Separation from the nearest UAV"})
    EXPECT_THAT(without_world, HasSubstr(title));
  EXPECT_THAT(without_world, Not(HasSubstr("Clearance to the true world")));
  page.clearance_by_uav = {{{0, 2}, {1, 1.5}}, {{0, 3}, {1, 2.5}}};
  EXPECT_THAT(ReportHtml(page), HasSubstr("Clearance to the true world"));
}

TEST(ReportHtml, NamesWhatWentWrong) {
  ReportPage page = SamplePage();
  page.metrics.completed = false;
  page.metrics.stop_reason = "time_limit";
  page.metrics.collisions = 2;
  EXPECT_THAT(ReportHtml(page), HasSubstr("Not completed (time_limit) after 2:00, 2 collisions"));
}

TEST(ReportHtml, OfAMissionThatNeverBeganIsStillAPage) {
  EXPECT_EQ(Unbalanced(ReportHtml(ReportPage{})), "");
}

TEST(SvgChart, KeepsTheHighestSampleOfALongCurve) {
  Series series;
  for (int k = 0; k < 100'000; ++k) series.emplace_back(k, k == 77'777 ? 50.0 : 1.0);
  const std::string svg = LineChart({"t", "x", "y"}, {{"a", series, 0}});
  EXPECT_LT(svg.size(), 30'000u);
  EXPECT_THAT(svg, HasSubstr(",12.0 "));  // the top of the frame: 50 on an axis up to 50
}

TEST(Base64, PadsAsRfc4648Says) {
  const auto of = [](const std::string& text) { return Base64({text.begin(), text.end()}); };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace citrine::logs
