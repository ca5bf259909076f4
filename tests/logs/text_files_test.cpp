#include <clocale>

#include <gtest/gtest.h>

#include "logs/number_text.h"
#include "logs/progress_csv.h"
#include "logs/tum.h"
#include "tests/support/state_at.h"

namespace citrine::logs {
namespace {

TEST(Tum, IsOneLineAStateWithTheQuaternionsRealPartLast) {
  UavState state = StateAt(1'020'000, {1, -2.5, 3});
  state.X_WB.q = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5);
  EXPECT_EQ(ToTum({state, StateAt(1'040'000, {0, 0, 1e-9})}),
            "1.020000 1.000000 -2.500000 3.000000 -0.500000 0.500000 0.500000 0.500000\n"
            "1.040000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000 1.000000\n");
}

TEST(ProgressCsv, HasALineOfNamesAndThenOneAMessageWithThePathsSoFar) {
  FlightRecord record;
  record.uavs.resize(2);
  record.uavs[0].states = {StateAt(0, {0, 0, 0}), StateAt(400'000, {3, 4, 0}), StateAt(900'000, {3, 4, 1})};
  record.uavs[1].states = {StateAt(600'000, {9, 9, 9})};
  MissionProgress progress;
  progress.surface_voxels = 10;
  progress.voxels_at_goal = 4;
  progress.elements_ise = 3;
  progress.elements_lqse = 2;
  progress.z_bar_sat = 0.02;
  progress.z_sat = 0.2;
  progress.z_goal = 0.049383;
  progress.known_pct = 12.5;
  record.progress = {{500'000, progress}};
  EXPECT_EQ(
      ProgressCsv(record),
      "time_s,surface_voxels,voxels_at_goal,elements_ise,elements_lqse,z_bar_sat,z_sat,z_goal,known_pct,"
      "path1_m,path2_m\n"
      "0.500,10,4,3,2,0.020000,0.200000,0.049383,12.500,5.000,0.000\n");
}

TEST(NumberText, HasAPointInEveryLocaleAndNoNegativeZero) {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(Fixed(1.25, 2), "1.25");
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(Fixed(-0.0001, 2), "0.00");
  EXPECT_EQ(Fixed(-0.25, 1), "-0.2");
  EXPECT_EQ(Fixed(std::nullopt, 2), "–");
  EXPECT_EQ(MinutesSeconds(289.2), "4:49");
  EXPECT_EQ(MinutesSeconds(59.9), "1:00");
  EXPECT_EQ(Bytes(999), "999 B");
  EXPECT_EQ(Bytes(12'345), "12.3 kB");
  EXPECT_EQ(Bytes(999'900), "1.0 MB");
}

}  // namespace
}  // namespace citrine::logs
