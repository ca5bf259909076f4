#include "modules/launch/progress_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine {
namespace {

using ::testing::HasSubstr;

MissionView SomeView() {
  MissionView view;
  view.clock.emplace();
  view.clock->utime = FromSeconds(134);
  view.progress.surface_voxels = 200;
  view.progress.voxels_at_goal = 50;
  view.progress.known_pct = 61;
  view.progress.elements_ise = 3;
  view.progress.elements_lqse = 4;
  view.uavs.resize(2);
  view.uavs[1].path_m = 60.7;
  view.uavs[1].speed_mps = 3.21;
  view.uavs[1].has_goal = true;
  return view;
}

TEST(ProgressText, SaysTimeFactorShareAndTheFleet) {
  const std::string text = ProgressText(SomeView(), 6.1);
  EXPECT_THAT(text, HasSubstr("t 02:14  6.1x  at goal 25.0%  known 61.0%"));
  EXPECT_THAT(text, HasSubstr("ASE 7 "));
  EXPECT_THAT(text, HasSubstr("| 1: idle 0.0 m/s 0 m | 2: 3.2 m/s 61 m"));
}

TEST(ProgressText, SaysThatItWaitsBeforeTheFirstClock) {
  EXPECT_EQ(ProgressText(MissionView(), 0), "waiting for the first CLOCK");
}

TEST(StallWatch, SaysOnceThatNothingNewWasSeenForAMinute) {
  StallWatch watch;
  MissionView view = SomeView();
  view.uavs[0].elements_unreachable = 5;
  view.uavs[1].elements_given_up = 1;
  EXPECT_FALSE(watch.Look(view));
  view.clock->utime += FromSeconds(59);
  EXPECT_FALSE(watch.Look(view));
  view.clock->utime += FromSeconds(1);
  EXPECT_THAT(watch.Look(view).value_or(""),
              HasSubstr("no new surface for 60 s: 7 active elements are left (5 unreachable, 1 given up)"));
  EXPECT_FALSE(watch.Look(view)) << "it has been said";
  ++view.progress.voxels_at_goal;
  view.clock->utime += FromSeconds(59);
  EXPECT_FALSE(watch.Look(view));
  view.clock->utime += FromSeconds(60);
  EXPECT_TRUE(watch.Look(view)) << "another stall";
}

TEST(StallWatch, IsContentWithAMissionThatHasNothingLeftOrIsOver) {
  StallWatch nothing_left, over;
  MissionView view = SomeView();
  view.progress.elements_ise = view.progress.elements_lqse = 0;
  EXPECT_FALSE(nothing_left.Look(view));
  view.clock->utime += FromSeconds(70);
  EXPECT_FALSE(nothing_left.Look(view));
  view = SomeView();
  EXPECT_FALSE(over.Look(view));
  view.clock->utime += FromSeconds(70);
  view.clock->state = Clock::State::kDone;
  EXPECT_FALSE(over.Look(view));
}

TEST(ProgressLine, WritesPlainLinesWhereThereIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  ProgressLine line(file);
  line.Show(MissionView());  // before the first clock: nothing to say
  line.Show(SomeView());
  line.Show(SomeView());  // sooner than 5 s: not said
  line.Finish();
  std::rewind(file);
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(text.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace citrine
