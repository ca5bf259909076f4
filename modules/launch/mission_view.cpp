#include "modules/launch/mission_view.h"

#include <charconv>
#include <exception>

#include "modules/channels.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/uav_state.h"

namespace citrine {
namespace {

template <class Message>
auto DecodeAs(const void* bytes, int size) {
  Message message{};
  if (message.decode(bytes, 0, size) != size) throw std::length_error("another type or cut short");
  return Decode(message);
}

/// The 1..N of UAV<i>_...; 0 for a channel that is not a UAV's.
std::size_t UavOf(const std::string& channel) {
  std::size_t uav = 0;
  if (channel.starts_with("UAV")) std::from_chars(channel.data() + 3, channel.data() + channel.size(), uav);
  return uav;
}

void HearState(const UavState& state, MissionView::Uav& uav) {
  if (uav.state) uav.path_m += (state.X_WB.p - uav.state->X_WB.p).norm();
  uav.speed_mps = state.v_W.norm();
  uav.state = state;
}

void HearStatus(const FleetStatus& status, MissionView::Uav& uav) {
  uav.has_goal = status.has_goal;
  uav.elements_unreachable = status.elements_unreachable;
  uav.elements_given_up = status.elements_given_up;
}

}  // namespace

void MissionView::Hear(const std::string& channel, const void* bytes, int size) try {
  const std::size_t uav = UavOf(channel);
  if (channel == channels::kClock.name) {
    const Clock heard = DecodeAs<citrine_lcm::clock_t>(bytes, size);
    if (heard.mission_id == mission_id) clock = heard;
  } else if (channel == channels::kMissionProgress.name) {
    progress = DecodeAs<citrine_lcm::mission_progress_t>(bytes, size);
  } else if (uav >= 1 && uav <= uavs.size() && channel.ends_with("_FLEET_STATUS")) {
    HearStatus(DecodeAs<citrine_lcm::fleet_status_t>(bytes, size), uavs[uav - 1]);
  } else if (uav >= 1 && uav <= uavs.size() && channel.ends_with("_STATE")) {
    HearState(DecodeAs<citrine_lcm::uav_state_t>(bytes, size), uavs[uav - 1]);
  }
} catch (const std::exception&) {  // whom it concerns counts it
}

}  // namespace citrine
