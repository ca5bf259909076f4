#include "modules/codec/fleet_assignment.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::fleet_assignment_t Encode(const FleetAssignment& assignment) {
  citrine_lcm::fleet_assignment_t message{};
  message.plan_id = assignment.plan_id;
  message.expiry_utime = assignment.expiry;
  message.sender = assignment.sender;
  message.selections = assignment.selections;
  message.num_uavs = static_cast<std::int32_t>(assignment.centroid_W_by_uav.size());
  for (const Eigen::Vector3d& p_W : assignment.centroid_W_by_uav) {
    message.x_W.push_back(p_W.x());
    message.y_W.push_back(p_W.y());
    message.z_W.push_back(p_W.z());
  }
  return message;
}

FleetAssignment Decode(const citrine_lcm::fleet_assignment_t& message) {
  Require(message.sender >= 1 && message.sender <= message.num_uavs,
          "fleet_assignment_t: the sender is not in the fleet");
  Require(message.plan_id > 0 && message.selections > 0, "fleet_assignment_t: plan_id or selections <= 0");
  FleetAssignment assignment{message.plan_id, message.sender, message.expiry_utime, message.selections, {}};
  for (std::int32_t i = 0; i < message.num_uavs; ++i) {
    RequireFinite("fleet_assignment_t: a centroid is not finite", message.x_W[i], message.y_W[i],
                  message.z_W[i]);
    assignment.centroid_W_by_uav.emplace_back(message.x_W[i], message.y_W[i], message.z_W[i]);
  }
  return assignment;
}

}  // namespace citrine
