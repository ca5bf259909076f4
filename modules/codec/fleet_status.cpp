#include "modules/codec/fleet_status.h"

#include "modules/codec/bad_message.h"
#include "modules/codec/geometry.h"

namespace citrine {

citrine_lcm::fleet_status_t Encode(const FleetStatus& status) {
  citrine_lcm::fleet_status_t message{};
  EncodePose(status.X_WB, message.p_WB, message.q_WB);
  EncodeVector(status.goal_W, message.goal_W);
  message.goal_yaw_rad = status.goal_yaw_rad;
  message.deciding_since_utime = status.deciding_since;
  message.decisions = status.decisions;
  message.plan_id = status.plan_id;
  message.map_version = status.map_version;
  message.corrected_selections_left = status.corrected_selections_left;
  message.elements_active = status.elements_active;
  message.elements_unreachable = status.elements_unreachable;
  message.elements_given_up = status.elements_given_up;
  message.activity = static_cast<std::int8_t>(status.activity);
  message.has_goal = status.has_goal;
  message.replanning = status.replanning;
  message.no_view_left = status.no_view_left;
  return message;
}

FleetStatus Decode(const citrine_lcm::fleet_status_t& message) {
  Require(message.activity >= message.IDLE && message.activity <= message.FLYING,
          "fleet_status_t: unknown activity");
  Require(message.decisions >= 0 && message.plan_id >= 0 && message.corrected_selections_left >= 0,
          "fleet_status_t: decisions, plan_id or corrected_selections_left < 0");
  Require(message.elements_active >= 0 && message.elements_unreachable >= 0 && message.elements_given_up >= 0,
          "fleet_status_t: a count of elements < 0");
  RequireFinite("fleet_status_t: goal_yaw_rad is not a number", message.goal_yaw_rad);
  FleetStatus status;
  status.X_WB = DecodePose(message.p_WB, message.q_WB, "fleet_status_t: X_WB is not a pose");
  status.activity = static_cast<FleetStatus::Activity>(message.activity);
  status.deciding_since = message.deciding_since_utime;
  status.has_goal = message.has_goal;
  status.goal_W = DecodeVector(message.goal_W, "fleet_status_t: goal_W is not finite");
  status.goal_yaw_rad = message.goal_yaw_rad;
  status.decisions = message.decisions;
  status.replanning = message.replanning;
  status.plan_id = message.plan_id;
  status.corrected_selections_left = message.corrected_selections_left;
  status.map_version = message.map_version;
  status.elements_active = message.elements_active;
  status.elements_unreachable = message.elements_unreachable;
  status.elements_given_up = message.elements_given_up;
  status.no_view_left = message.no_view_left;
  return status;
}

}  // namespace citrine
