#include "modules/codec/uav_state.h"

#include "modules/codec/bad_message.h"
#include "modules/codec/geometry.h"

namespace citrine {

citrine_lcm::uav_state_t Encode(const UavState& state) {
  citrine_lcm::uav_state_t message{};
  message.utime = state.utime;
  EncodePose(state.X_WB, message.p_WB, message.q_WB);
  EncodeVector(state.v_W, message.v_W);
  EncodeVector(state.omega_B, message.omega_B);
  message.num_contacts = state.contacts;
  return message;
}

UavState Decode(const citrine_lcm::uav_state_t& message) {
  Require(message.num_contacts >= 0, "uav_state_t: num_contacts < 0");
  UavState state;
  state.utime = message.utime;
  state.X_WB = DecodePose(message.p_WB, message.q_WB, "uav_state_t: X_WB is not a pose");
  state.v_W = DecodeVector(message.v_W, "uav_state_t: v_W is not finite");
  state.omega_B = DecodeVector(message.omega_B, "uav_state_t: omega_B is not finite");
  state.contacts = message.num_contacts;
  return state;
}

}  // namespace citrine
