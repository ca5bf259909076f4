#include "planner/safety/flight_executive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/planner/safety/fleet_flight.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;
using Phase = FlightStatus::Phase;

constexpr double kContinuity = 1e-9;

void ExpectWithinLimits(const FleetFlight& flight) {
  EXPECT_LT(flight.jump, kContinuity);
  EXPECT_LE(flight.fastest_mps, 4.5 * 1.01);
  EXPECT_LE(flight.hardest_mps2, 4.8 * 1.01);
}

TEST(FlightExecutive, FliesThroughAHundredForestsWithoutComingNearerThanTheRadius) {
  int flown = 0, reached = 0;
  double seconds = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Vector3d start(2.5, 2.5, 4), goal(17.5, 17, 4);
    const PlanningMap map = MapOf({20, 20, 8}, DistanceToForest(Forest(seed, 20, 16, start, goal)));
    FleetFlight flight(map, {start});
    if (!flight.Send(1, goal)) continue;
    ++flown;
    reached += flight.FlyUntil(1, Phase::kReached, 30);
    seconds += Seconds(flight.now);
    EXPECT_GE(flight.to_occupied_m, 1.0 - 1e-3) << "forest " << seed;  // the check samples every 9 cm
    ExpectWithinLimits(flight);
  }
  std::printf("%d of %d flights reached their goal in %.2f s on average\n", reached, flown, seconds / flown);
  EXPECT_GT(flown, 60);
  EXPECT_EQ(reached, flown);
}

TEST(FlightExecutive, FliesThroughAGapOfThreeMetres) {
  const PlanningMap map = MapOf({20, 24, 8}, WallWithGap(10.1, 13.1));
  FleetFlight flight(map, {{4, 4, 4}});
  ASSERT_TRUE(flight.Send(1, {16, 18, 4}));
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 30));
  EXPECT_GE(flight.to_occupied_m, 1.0 - 1e-3);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, LeavesTheKnownFreeBallOfItsSpawn) {
  PlanningMap map(GridOf({20, 20, 10}), Quantisation(0.5, 1 / (4.5 * 4.5)));
  const Vector3d spawn(10, 10, 4);
  map.AssumeFree({spawn, 2.25});
  FleetFlight flight(map, {spawn});
  ASSERT_TRUE(flight.Send(1, {14, 12, 5}));
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 10));
  EXPECT_GT((flight.Position(1) - spawn).norm(), 0.5);
  EXPECT_GE(flight.to_unknown_m, 1.0 - 1e-3);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, DoesNotStopBetweenGoals) {
  const PlanningMap map = MapOf({40, 12, 8}, EmptySpace);
  FleetFlight flight(map, {{3, 6, 4}});
  flight.Send(1, {15, 6, 4});
  flight.Fly(2.5);
  const double speed = flight.uav(1).committed()->At(flight.now).v_W.norm();
  ASSERT_GT(speed, 2);
  flight.Send(1, {30, 7, 4});
  double slowest = speed;
  for (int i = 0; i < 100; ++i) {
    flight.Step();
    slowest = std::min(slowest, flight.uav(1).committed()->At(flight.now).v_W.norm());
  }
  EXPECT_GT(slowest, 0.9 * speed);
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 20));
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, FliesThroughTheGoalOfThePathBeforeWithoutAStop) {
  const PlanningMap map = MapOf({40, 30, 8}, EmptySpace);
  FleetFlight flight(map, {{3, 6, 4}});
  const Vector3d first(15, 6, 4), second(20, 12, 4);
  flight.Send(1, first);
  flight.Fly(2.5);
  Path onward;
  onward.id = 100;
  onward.waypoints = {{flight.Position(1), 1}, {first, 1}, {second, 1}};
  flight.uav(1).HearPath(onward);
  double nearest = 100, slowest = 100;
  while (flight.Position(1).y() < 9) {
    flight.Step();
    nearest = std::min(nearest, (flight.Position(1) - first).norm());
    slowest = std::min(slowest, flight.uav(1).committed()->At(flight.now).v_W.norm());
  }
  EXPECT_LE(nearest, kReached_m);
  EXPECT_GT(slowest, 1.5);  // a turn of 50 degrees
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 20));
  EXPECT_LE((flight.Position(1) - second).norm(), kReached_m);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, GoesOnToAnotherGoalOnlyThroughThePlaceThatIsStillToBePassed) {
  const PlanningMap map = MapOf({40, 30, 8}, EmptySpace);
  FleetFlight flight(map, {{3, 6, 4}});
  const Vector3d first(15, 6, 4);
  flight.Send(1, first);
  flight.Fly(2.5);
  double nearest = 100;
  std::int64_t id = 100;
  for (const Vector3d& next : {Vector3d(20, 12, 4), Vector3d(20, 2, 4)}) {
    Path onward;
    onward.id = id++;
    onward.waypoints = {{flight.Position(1), 1}, {first, 1}, {next, 1}};
    flight.uav(1).HearPath(onward);
    flight.Step();
  }
  while (flight.status(1).phase != Phase::kReached) {
    flight.Step();
    nearest = std::min(nearest, (flight.Position(1) - first).norm());
  }
  EXPECT_LE(nearest, kReached_m);
  EXPECT_LE((flight.Position(1) - Vector3d(20, 2, 4)).norm(), kReached_m);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, PlansTwiceASecondAndNoMoreWhileAPathEndsWhereItCannotGo) {
  const PlanningMap map = MapOf({40, 12, 8}, EmptySpace, [](const Vector3d& p) { return p.x() < 20; });
  FleetFlight flight(map, {{3, 6, 4}});
  Path into_the_unknown;
  into_the_unknown.id = 1;
  into_the_unknown.waypoints = {{{3, 6, 4}, 1}, {{30, 6, 4}, 1}};
  flight.uav(1).HearPath(into_the_unknown);
  int plans = 0;
  while (flight.now < FromSeconds(3)) {
    flight.Step();
    plans += flight.uav(1).planned();
  }
  EXPECT_GT(flight.Position(1).x(), 8);  // on its way to the edge of what is known
  EXPECT_GE(plans, 5);
  EXPECT_LE(plans, 6);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, HasReachedAGoalAtWhichItHoversAlready) {
  const PlanningMap map = MapOf({20, 12, 8}, EmptySpace);
  FleetFlight flight(map, {{5, 6, 4}});
  Path here;
  here.id = 7;
  here.waypoints = {{{5, 6, 4}, 1}, {{5, 6, 4}, 1}};
  flight.uav(1).HearPath(here);
  flight.Step();
  EXPECT_EQ(flight.status(1).phase, Phase::kReached);
  EXPECT_EQ(flight.status(1).path_id, 7);
}

TEST(FlightExecutive, StopsBeforeAWallThatTheMapShowsOnlyAtFourAndAThirdMetresAtFullSpeed) {
  PlanningMap map = MapOf({40, 12, 8}, EmptySpace);
  FleetFlight flight(map, {{3, 6, 4}});
  flight.Send(1, {37, 6, 4});
  while (flight.Position(1).x() < 15) flight.Step();
  ASSERT_GT(flight.uav(1).committed()->At(flight.now).v_W.norm(), 4.0);
  const double wall_x = flight.Position(1).x() + 4.33;
  Write([wall_x](const Vector3d& p) { return wall_x - p.x(); }, Everywhere, 2, &map);
  flight.Step(true);
  flight.Fly(8);
  EXPECT_GE(wall_x - flight.Position(1).x(), 0.99);  // 4.33 m, less 0.54 m of replan_ahead, 2.7 m of braking
  EXPECT_GE(flight.to_occupied_m, 0.99 - 0.125);     // which reads half a voxel less before a wall
  ExpectWithinLimits(flight);
  EXPECT_EQ(flight.status(1).phase, Phase::kBlocked);
  EXPECT_FALSE(flight.status(1).reason.empty());
}

class SuddenWall : public testing::TestWithParam<double> {};

TEST_P(SuddenWall, IsBrakedBeforeThoughOnlyTheNewestScanShowsIt) {
  const PlanningMap map = MapOf({40, 12, 8}, EmptySpace);
  FleetFlight flight(map, {{3, 6, 4}});
  flight.Send(1, {37, 6, 4});
  while (flight.Position(1).x() < 15) flight.Step();
  ASSERT_GT(flight.uav(1).committed()->At(flight.now).v_W.norm(), 4.3);
  const double wall_x = flight.Position(1).x() + GetParam();
  for (int i = 0; i < 300; ++i) {
    if (i % 5 == 0) {
      LidarScan scan;
      scan.measured = flight.now;
      scan.X_WS.p = flight.Position(1);
      for (int row = 0; row < scan.model.rows; ++row)
        for (int col = 0; col < scan.model.cols; ++col) {
          const double x = scan.model.Direction(row, col).x();
          const double range_m = x > 0.01 ? (wall_x - scan.X_WS.p.x()) / x : 100;
          scan.ranges_m.push_back(range_m < 10 ? static_cast<float>(range_m) : kNoReturn);
        }
      flight.uav(1).HearScan(scan);
    }
    flight.Step();
  }
  EXPECT_GT(wall_x - flight.Position(1).x(),
            0.8);  // the guard's own distance: the radius less the map's error
  EXPECT_LT(flight.uav(1).committed()->At(flight.now).v_W.norm(), 1e-9);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, TakesOverInFlightOnceTheUavIsAtRest) {
  const PlanningMap map = MapOf({20, 20, 8}, [](const Vector3d&) { return 5.0; });
  FlightExecutive executive(FlightSettings{}, map, PlainSolve());
  UavState state;
  state.X_WB.p = {4, 4, 4};
  state.v_W = {2, 0, 0};
  executive.HearState(state);
  EXPECT_FALSE(executive.committed()) << "whoever was there before has committed to an end at rest";
  state.X_WB.p = {6, 4, 4};
  state.v_W.setZero();
  executive.HearState(state);
  ASSERT_TRUE(executive.committed());
  EXPECT_EQ(executive.committed()->At(0).p_W, Vector3d(6, 4, 4));
}

TEST(Trajectory, SupersedesByIdAndByStartWhereItsSmootherCountsAnew) {
  const auto of = [](std::int64_t id, Utime start) {
    Trajectory trajectory = Hover(Vector3d::Zero(), 0, start);
    trajectory.id = id;
    return trajectory;
  };
  EXPECT_TRUE(Supersedes(of(8, 50), of(7, 50)));
  EXPECT_FALSE(Supersedes(of(7, 50), of(7, 50))) << "a repetition";
  EXPECT_FALSE(Supersedes(of(6, 40), of(7, 50))) << "one that comes late";
  EXPECT_TRUE(Supersedes(of(1, 60), of(7, 50))) << "the first of a smoother that was started again";
}

// [m] ahead: all but too late; and the sensor's range.
INSTANTIATE_TEST_SUITE_P(Ahead, SuddenWall, testing::Values(4.5, 10.0));

TEST(FlightExecutive, ComesToRestWhenToldTo) {
  const PlanningMap map = MapOf({40, 12, 8}, EmptySpace);
  FleetFlight flight(map, {{3, 6, 4}});
  flight.Send(1, {37, 6, 4});
  flight.Fly(3);
  Path stop;
  stop.id = 99;
  flight.uav(1).HearPath(stop);
  flight.Step();
  EXPECT_EQ(flight.status(1).phase, Phase::kBraking);
  flight.Fly(3);
  EXPECT_EQ(flight.status(1).phase, Phase::kWaiting);
  EXPECT_EQ(flight.status(1).path_id, 99);
  EXPECT_LT(flight.Position(1).x(), 20);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, ReportsBlockedAfterThreeFailuresAndRecoversWithAnotherPath) {
  const PlanningMap map =
      MapOf({30, 24, 8}, [](const Vector3d& p) { return (p - Vector3d(20, 12, 4)).norm() - 2; });
  FleetFlight flight(map, {{5, 12, 4}});
  Path into_the_sphere;
  into_the_sphere.id = 50;
  into_the_sphere.waypoints = {{{5, 12, 4}, 1}, {{20, 12, 4}, 1}};
  flight.uav(1).HearPath(into_the_sphere);
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kBlocked, 12));
  EXPECT_EQ(flight.status(1).path_id, 50);
  Path out;
  out.id = 51;
  out.waypoints = {{flight.Position(1), 1}, {{5, 20, 4}, 1}};
  flight.uav(1).HearPath(out);
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 12));
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, FliesStraightLegsIfTheSolverFails) {
  const SolveMotion broken = [](const FlightScene&, const FlightWeights&, const SmoothingTask& task,
                                const SmoothingResult*) {
    SmoothingResult nonsense;
    Knot end;
    end.p = task.points_W.back();
    nonsense.spline.Solve({task.start, end}, {0.01});
    return nonsense;
  };
  const PlanningMap map = MapOf({20, 24, 8}, WallWithGap(10.1, 13.1));
  FleetFlight flight(map, {{4, 4, 4}}, broken);
  ASSERT_TRUE(flight.Send(1, {16, 18, 4}));
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 40));
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, KeepsTwoUavsApartThatMeetHeadOn) {
  const PlanningMap map = MapOf({40, 20, 10}, EmptySpace);
  for (const double offset : {0.0, 0.5, 1.5}) {
    FleetFlight flight(map, {{4, 10, 5}, {36, 10 + offset, 5}});
    flight.Send(1, {32, 10, 5});
    flight.Send(2, {8, 10, 5});
    EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 40)) << offset;
    EXPECT_TRUE(flight.status(2).phase == Phase::kReached || flight.FlyUntil(2, Phase::kReached, 30))
        << offset;
    EXPECT_GE(flight.separation_m, 2.0) << offset;
    ExpectWithinLimits(flight);
  }
}

TEST(FlightExecutive, DoesNotLetTwoUavsWaitForEachOtherInACorridor) {
  // 3 m wide and 3 m high: nobody can pass.
  const PlanningMap map = MapOf({40, 8, 8}, [](const Vector3d& p) {
    return std::min(1.5 - std::abs(p.y() - 4), 1.5 - std::abs(p.z() - 4));
  });
  FleetFlight flight(map, {{4, 4, 4}, {36, 4, 4}});
  ASSERT_TRUE(flight.Send(1, {34, 4, 4}));
  ASSERT_TRUE(flight.Send(2, {6, 4, 4}));
  bool said = false;
  for (int i = 0; i < 1500 && !said; ++i) {
    flight.Step();
    said = flight.status(1).phase == Phase::kBlocked || flight.status(2).phase == Phase::kBlocked;
  }
  EXPECT_TRUE(said);
  EXPECT_GE(flight.separation_m, 2.0);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, DoesNotFlyIntoATeammateThatHoversOnTheWay) {
  const PlanningMap map = MapOf({30, 20, 10}, EmptySpace);
  FleetFlight flight(map, {{4, 10, 5}, {15, 10, 5}});
  flight.Step();
  flight.Send(1, {26, 10, 5});
  EXPECT_TRUE(flight.FlyUntil(1, Phase::kReached, 30));
  EXPECT_GE(flight.separation_m, 2.2 - 1e-3);
  ExpectWithinLimits(flight);
}

TEST(FlightExecutive, GivesTheSameBitsEveryTime) {
  const auto fly = [] {
    const Vector3d start(2.5, 2.5, 4), goal(17.5, 17, 4);
    const PlanningMap map = MapOf({20, 20, 8}, DistanceToForest(Forest(5, 20, 14, start, goal)));
    FleetFlight flight(map, {start, goal});
    flight.Send(1, goal - Vector3d(4, 0, 0));
    flight.Send(2, start + Vector3d(0, 3, 0));
    flight.Fly(10);
    return std::pair(flight.Position(1), flight.Position(2));
  };
  const auto first = fly(), second = fly();
  EXPECT_EQ(first.first, second.first);
  EXPECT_EQ(first.second, second.second);
}

}  // namespace
}  // namespace citrine::planner
