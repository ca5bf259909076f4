#include <limits>

#include <gtest/gtest.h>

#include "modules/codec/bad_message.h"
#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/flight_status.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/path.h"
#include "modules/codec/strategy_message.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "tests/modules/codec/over_the_wire.h"

namespace citrine {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
// Not a round number in any field: what decoding would round or swap shows.
const Pose kPose{{1.1, -2.2, 3.3}, Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5)};

void ExpectSame(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.p, b.p);
  EXPECT_EQ(a.q.coeffs(), b.q.coeffs());
}

TEST(UavStateCodec, LosesNothing) {
  const UavState said{123, kPose, {4.1, 5.2, 6.3}, {-7.1, 8.2, -9.3}, 10};
  const UavState heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.utime, said.utime);
  ExpectSame(heard.X_WB, said.X_WB);
  EXPECT_EQ(heard.v_W, said.v_W);
  EXPECT_EQ(heard.omega_B, said.omega_B);
  EXPECT_EQ(heard.contacts, said.contacts);
}

TEST(UavStateCodec, RefusesWhatIsNoPose) {
  auto message = Encode(UavState{});
  message.q_WB[1] = 1;
  EXPECT_THROW(Decode(message), BadMessage) << "not a unit quaternion";
  message = Encode(UavState{});
  message.p_WB[2] = kNan;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(UavState{});
  message.num_contacts = -1;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(FleetStatusCodec, LosesNothing) {
  FleetStatus said;
  said.X_WB = kPose;
  said.activity = FleetStatus::Activity::kFlying;
  said.deciding_since = 11;
  said.has_goal = true;
  said.goal_W = {1.5, 2.5, 3.5};
  said.goal_yaw_rad = 0.7;
  said.decisions = 12;
  said.replanning = true;
  said.plan_id = 13;
  said.corrected_selections_left = 14;
  said.map_version = 15;
  said.elements_active = 16;
  said.elements_unreachable = 17;
  said.elements_given_up = 18;
  said.no_view_left = true;
  const FleetStatus heard = Decode(OverTheWire(Encode(said)));
  ExpectSame(heard.X_WB, said.X_WB);
  EXPECT_EQ(heard.activity, said.activity);
  EXPECT_EQ(heard.deciding_since, 11);
  EXPECT_TRUE(heard.has_goal);
  EXPECT_EQ(heard.goal_W, said.goal_W);
  EXPECT_EQ(heard.goal_yaw_rad, 0.7);
  EXPECT_EQ(heard.decisions, 12);
  EXPECT_TRUE(heard.replanning);
  EXPECT_EQ(heard.plan_id, 13);
  EXPECT_EQ(heard.corrected_selections_left, 14);
  EXPECT_EQ(heard.map_version, 15);
  EXPECT_EQ(heard.elements_active, 16);
  EXPECT_EQ(heard.elements_unreachable, 17);
  EXPECT_EQ(heard.elements_given_up, 18);
  EXPECT_TRUE(heard.no_view_left);
}

TEST(FleetStatusCodec, TellsItsFlagsApart) {
  FleetStatus said;
  said.has_goal = true;
  EXPECT_TRUE(Decode(Encode(said)).has_goal);
  EXPECT_FALSE(Decode(Encode(said)).replanning);
  EXPECT_FALSE(Decode(Encode(said)).no_view_left);
}

TEST(FleetStatusCodec, RefusesAnUnknownActivityAndNegativeCounts) {
  auto message = Encode(FleetStatus{});
  message.activity = 3;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(FleetStatus{});
  message.elements_given_up = -1;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(FleetStatus{});
  message.goal_W[0] = kNan;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(FleetAssignmentCodec, LosesNothing) {
  const FleetAssignment said{21, 2, 22, 3, {{1.1, 2.2, 3.3}, {4.4, 5.5, 6.6}}};
  const FleetAssignment heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.plan_id, 21);
  EXPECT_EQ(heard.sender, 2);
  EXPECT_EQ(heard.expiry, 22);
  EXPECT_EQ(heard.selections, 3);
  EXPECT_EQ(heard.centroid_W_by_uav, said.centroid_W_by_uav);
}

TEST(FleetAssignmentCodec, RefusesASenderOutsideTheFleet) {
  auto message = Encode(FleetAssignment{21, 2, 22, 3, {{1, 2, 3}, {4, 5, 6}}});
  message.sender = 3;
  EXPECT_THROW(Decode(message), BadMessage);
  message.sender = 1;
  message.y_W[1] = kNan;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(FlightStatusCodec, LosesNothing) {
  const FlightStatus said{FlightStatus::Phase::kBraking, 31, 32, 3.3, 4.4, 5, "a wall"};
  const FlightStatus heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.phase, said.phase);
  EXPECT_EQ(heard.path_id, 31);
  EXPECT_EQ(heard.trajectory_id, 32);
  EXPECT_EQ(heard.time_to_go_s, 3.3);
  EXPECT_EQ(heard.distance_to_go_m, 4.4);
  EXPECT_EQ(heard.failures, 5);
  EXPECT_EQ(heard.reason, "a wall");
}

TEST(FlightStatusCodec, RefusesAnUnknownPhase) {
  auto message = Encode(FlightStatus{});
  message.phase = 5;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(MissionProgressCodec, LosesNothing) {
  const MissionProgress said{
      41,  42,  40,  44,   45,
      0.1, 0.2, 0.3, 46.5, {{10, 9, 8, 0.11, 0.12, 0.13}, {20, 19, 18, 0.21, 0.22, 0.23}}};
  const MissionProgress heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.map_version, 41);
  EXPECT_EQ(heard.surface_voxels, 42);
  EXPECT_EQ(heard.voxels_at_goal, 40);
  EXPECT_EQ(heard.elements_ise, 44);
  EXPECT_EQ(heard.elements_lqse, 45);
  EXPECT_EQ(heard.z_bar_sat, 0.1);
  EXPECT_EQ(heard.z_sat, 0.2);
  EXPECT_EQ(heard.z_goal, 0.3);
  EXPECT_EQ(heard.known_pct, 46.5);
  ASSERT_EQ(heard.parts.size(), 2u);
  EXPECT_EQ(heard.parts[0].voxels_at_goal, 9);
  EXPECT_EQ(heard.parts[1].surface_voxels, 20);
  EXPECT_EQ(heard.parts[1].voxels_at_goal, 19);
  EXPECT_EQ(heard.parts[1].elements_ise, 18);
  EXPECT_EQ(heard.parts[1].z_bar_sat, 0.21);
  EXPECT_EQ(heard.parts[1].z_sat, 0.22);
  EXPECT_EQ(heard.parts[1].z_goal, 0.23);
}

TEST(MissionProgressCodec, RefusesMoreVoxelsAtGoalThanThereAre) {
  auto message = Encode(MissionProgress{});
  message.voxels_at_goal = 1;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(MissionProgressCodec, RefusesThatOfAPartToo) {
  MissionProgress progress;
  progress.parts.resize(2);
  auto message = Encode(progress);
  message.part_voxels_at_goal[1] = 1;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(PathCodec, LosesNothing) {
  Path said{51, {{{1.1, 2.2, 3.3}, 0.4}, {{5.5, 6.6, 7.7}, 0.8}}, 0.9, false, {1.25, 2.25, 3.25}};
  const Path heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.id, 51);
  ASSERT_EQ(heard.waypoints.size(), 2u);
  EXPECT_EQ(heard.waypoints[1].p_W, said.waypoints[1].p_W);
  EXPECT_EQ(heard.waypoints[0].free_radius_m, 0.4);
  EXPECT_EQ(heard.goal_yaw_rad, 0.9);
  EXPECT_FALSE(heard.ends_at_goal);
  EXPECT_EQ(heard.limits.radius_m, 1.25);
  EXPECT_EQ(heard.limits.speed_max_mps, 2.25);
  EXPECT_EQ(heard.limits.acceleration_max_mps2, 3.25);
}

TEST(PathCodec, PassesAPathWithoutWaypointsAndRefusesLimitsOfNothing) {
  auto message = Encode(Path{});
  EXPECT_TRUE(Decode(message).waypoints.empty());
  message.speed_max_mps = 0;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(TrajectoryCodec, LosesNothing) {
  Trajectory said{61, 62, 63, {}};
  for (int i = 0; i < 3; ++i) {
    TrajectorySegment segment{0.1 * (i + 1), {}};
    for (int axis = 0; axis < 4; ++axis)
      for (int k = 0; k < 6; ++k) segment.coefficients(axis, k) = 1.0 / (1 + i + 3 * axis + 12 * k);
    said.segments.push_back(segment);
  }
  const Trajectory heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.id, 61);
  EXPECT_EQ(heard.path_id, 62);
  EXPECT_EQ(heard.start, 63);
  ASSERT_EQ(heard.segments.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(heard.segments[i].duration_s, said.segments[i].duration_s);
    EXPECT_EQ(heard.segments[i].coefficients, said.segments[i].coefficients);
  }
}

TEST(TrajectoryCodec, RefusesCountsThatDoNotAgree) {
  auto message = Encode(Hover({1, 2, 3}, 0.5, 0));
  message.num_coefficients = 1;
  for (auto* axis : {&message.x_W, &message.y_W, &message.z_W, &message.yaw_rad}) axis->resize(1);
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(Trajectory{});
  EXPECT_THROW(Decode(message), BadMessage) << "no segment";
  message = Encode(Hover({1, 2, 3}, 0.5, 0));
  message.z_W[0] = kNan;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(StrategyMessageCodec, LosesNothing) {
  const StrategyMessage said{1, 3, "pair_request", {0, 255, 7}};
  const StrategyMessage heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.from_uav, 1);
  EXPECT_EQ(heard.to_uav, 3);
  EXPECT_EQ(heard.kind, "pair_request");
  EXPECT_EQ(heard.bytes, said.bytes);
}

TEST(StrategyMessageCodec, RefusesASenderThatIsNoUav) {
  EXPECT_THROW(Decode(Encode(StrategyMessage{})), BadMessage);
}

}  // namespace
}  // namespace citrine
