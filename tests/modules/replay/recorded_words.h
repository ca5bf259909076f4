#pragma once

#include "modules/channels.h"
#include "modules/codec/uav_state.h"
#include "modules/runtime/log_event.h"

namespace citrine::test {

/// A message as a log has it.
template <class Message>
LogEvent Recorded(const std::string& channel, Utime utime, std::int64_t seq, Message message) {
  message.utime = utime;
  message.seq = seq;
  return {utime, channel, Bus::ToBytes(message)};
}

inline LogEvent RecordedState(Utime utime, std::int64_t seq, double x_m, int uav = 1) {
  UavState state;
  state.X_WB.p = {x_m, 2, 3};
  return Recorded(channels::kUavState.Of(uav), utime, seq, Encode(state));
}

/// One waypoint.
inline LogEvent RecordedPath(Utime utime, std::int64_t seq, double x_m) {
  citrine_lcm::path_t path{};
  path.path_id = 7;
  path.num_waypoints = 1;
  path.x_W = {x_m};
  path.y_W = path.z_W = path.free_radius_m = {1};
  return Recorded(channels::kPath.Of(1), utime, seq, path);
}

/// Straight ahead at 1 m/s from x = 0 at `start`, for 10 s.
inline LogEvent RecordedTrajectory(Utime utime, std::int64_t seq, Utime start) {
  citrine_lcm::trajectory_t message{};
  message.trajectory_id = 1;
  message.start_utime = start;
  message.num_segments = 1;
  message.num_coefficients = 6;
  message.duration_s = {10};
  message.x_W = {1e-6 * static_cast<double>(start), 1, 0, 0, 0, 0};
  message.y_W = message.z_W = message.yaw_rad = std::vector<double>(6, 0);
  return Recorded(channels::kTrajectory.Of(1), utime, seq, message);
}

}  // namespace citrine::test
