#include "modules/codec/flight_status.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::flight_status_t Encode(const FlightStatus& status) {
  citrine_lcm::flight_status_t message{};
  message.path_id = status.path_id;
  message.trajectory_id = status.trajectory_id;
  message.time_to_go_s = status.time_to_go_s;
  message.distance_to_go_m = status.distance_to_go_m;
  message.failures = status.failures;
  message.phase = static_cast<std::int8_t>(status.phase);
  message.reason = status.reason;
  return message;
}

FlightStatus Decode(const citrine_lcm::flight_status_t& message) {
  Require(message.phase >= message.WAITING && message.phase <= message.BLOCKED,
          "flight_status_t: unknown phase");
  Require(message.path_id >= 0 && message.trajectory_id >= 0 && message.failures >= 0,
          "flight_status_t: path_id, trajectory_id or failures < 0");
  RequireFinite("flight_status_t: what is left to go is not a number", message.time_to_go_s,
                message.distance_to_go_m);
  return {static_cast<FlightStatus::Phase>(message.phase),
          message.path_id,
          message.trajectory_id,
          message.time_to_go_s,
          message.distance_to_go_m,
          message.failures,
          message.reason};
}

}  // namespace citrine
