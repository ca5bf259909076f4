#include "modules/codec/path.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::path_t Encode(const Path& path) {
  citrine_lcm::path_t message{};
  message.path_id = path.id;
  message.goal_yaw_rad = path.goal_yaw_rad;
  message.radius_m = path.limits.radius_m;
  message.speed_max_mps = path.limits.speed_max_mps;
  message.acceleration_max_mps2 = path.limits.acceleration_max_mps2;
  message.ends_at_goal = path.ends_at_goal;
  message.num_waypoints = static_cast<std::int32_t>(path.waypoints.size());
  for (const Waypoint& waypoint : path.waypoints) {
    message.x_W.push_back(waypoint.p_W.x());
    message.y_W.push_back(waypoint.p_W.y());
    message.z_W.push_back(waypoint.p_W.z());
    message.free_radius_m.push_back(waypoint.free_radius_m);
  }
  return message;
}

Path Decode(const citrine_lcm::path_t& message) {
  RequireFinite("path_t: a yaw or limit is not a number", message.goal_yaw_rad, message.radius_m,
                message.speed_max_mps, message.acceleration_max_mps2);
  Require(message.radius_m > 0 && message.speed_max_mps > 0 && message.acceleration_max_mps2 > 0,
          "path_t: a limit <= 0");
  Require(message.path_id >= 0, "path_t: path_id < 0");
  Path path;
  path.id = message.path_id;
  path.goal_yaw_rad = message.goal_yaw_rad;
  path.ends_at_goal = message.ends_at_goal;
  path.limits = {message.radius_m, message.speed_max_mps, message.acceleration_max_mps2};
  for (std::int32_t i = 0; i < message.num_waypoints; ++i) {
    RequireFinite("path_t: a waypoint is not finite", message.x_W[i], message.y_W[i], message.z_W[i],
                  message.free_radius_m[i]);
    Require(message.free_radius_m[i] >= 0, "path_t: free_radius_m < 0");
    path.waypoints.push_back({{message.x_W[i], message.y_W[i], message.z_W[i]}, message.free_radius_m[i]});
  }
  return path;
}

}  // namespace citrine
