#include "logs/report_html.h"

#include <cctype>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "logs/html_text.h"
#include "logs/svg_chart.h"

namespace citrine::logs {
namespace {

using testing::HasSubstr;
using testing::Not;

ReportPage Page() {
  ReportPage page;
  page.metrics.mission = "house";
  page.metrics.world = "worlds/house.sdf";
  page.metrics.strategy = "quality_adaptive";
  page.metrics.uavs = 2;
  page.metrics.completed = true;
  page.metrics.stop_reason = "surface_complete";
  page.metrics.mission_time_s = 120;
  page.metrics.coverage_pct = 79.9;
  page.metrics.precision_pct = 88;
  page.metrics.f_score_pct = 83.75;
  page.metrics.collisions = 0;
  page.volume_W = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(45, 40, 20));
  page.config_toml = "[mission]\nname = \"a <b> & 'c'\"\n";
  page.command = "./citrine run house --set planner.gamma=2";
  page.topdown_png = {1, 2, 3, 4};
  page.record.uavs.resize(2);
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 6000; ++k) {
      UavState state;
      state.utime = k * 20'000;
      state.X_WB.p = {5 + 20 * i + 4 * std::cos(k * 0.01), 20 + 10 * std::sin(k * 0.01), 3};
      state.v_W = {-2 * std::sin(k * 0.01), 5 * std::cos(k * 0.01), 0};
      page.record.uavs[i].states.push_back(state);
    }
  for (int k = 0; k < 240; ++k) {
    MissionProgress progress;
    progress.surface_voxels = 100 * k;
    progress.voxels_at_goal = 80 * k;
    page.record.progress.push_back({k * 500'000, progress});
  }
  for (int k = 0; k < 5; ++k) {
    FleetAssignment assignment;
    assignment.plan_id = k * 20'000'000 * 16 + 1;
    page.record.assignments.push_back(assignment);
    FleetStatus status;
    status.decisions = k;
    page.record.uavs[0].statuses.push_back({k * 10'000'000, status});
  }
  page.goal_coverage_pct = {{1, 10}, {2, 50}};
  page.object_goal_coverage_pct = {{1, 5}, {2, 40}};
  page.record.end = 120'000'000;
  page.record.bytes_by_channel = {
      {"UAV1_STATE", 500'000}, {"UAV2_STATE", 500'000}, {"MAP_BLOCKS", 9'000'000}};
  page.record.samples = {{"replan_ms", {1, 2, 30}}, {"views", {5}}};
  return page;
}

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
  const std::string html = ReportHtml(Page());
  for (const char* reference : {"http:", "https:", "//", "<link", "<script", "@import", "url("})
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,AQIDBA==\""));
}

TEST(ReportHtml, ClosesEveryTagItOpens) { EXPECT_EQ(Unbalanced(ReportHtml(Page())), ""); }

TEST(ReportHtml, SaysTheVerdictTheNumbersAndHowToFlyItAgain) {
  const std::string html = ReportHtml(Page());
  EXPECT_THAT(html, HasSubstr("Surface complete after 2:00, no collision"));
  EXPECT_THAT(html, HasSubstr("79.90"));
  EXPECT_THAT(html, HasSubstr("80.73"));       // the paper's coverage of House
  EXPECT_THAT(html, Not(HasSubstr("95.48")));  // and not that of Structure
  EXPECT_THAT(html, HasSubstr("--set planner.gamma=2"));
  EXPECT_THAT(html, HasSubstr("a &lt;b&gt; &amp; &#39;c&#39;"));
  EXPECT_THAT(html, HasSubstr("UAV*_STATE"));
}

TEST(ReportHtml, DrawsWhatChangedOverTheMission) {
  const std::string html = ReportHtml(Page());
  for (const char* title : {"True surface seen from within d*", "Active elements", "Paths from above",
                            "Goals chosen", "Imbalance corrections", "Said on the bus", "Computing time"})
    EXPECT_THAT(html, HasSubstr(std::string("<figcaption>") + title));
  // Corrections at 0, 20, 40, 60 and 80 of 120 s rise by one each: of an axis of 5 over 188 pixels.
  EXPECT_THAT(html, HasSubstr("54.0,162.4 106.5,162.4 106.5,124.8 "));
}

TEST(ReportHtml, NamesWhatWentWrong) {
  ReportPage page = Page();
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
