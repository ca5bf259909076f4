#include "modules/codec/trajectory.h"

#include "modules/codec/bad_message.h"

namespace citrine {
namespace {

constexpr int kCoefficients = 6;

}  // namespace

citrine_lcm::trajectory_t Encode(const Trajectory& trajectory) {
  citrine_lcm::trajectory_t message{};
  message.trajectory_id = trajectory.id;
  message.path_id = trajectory.path_id;
  message.start_utime = trajectory.start;
  message.num_segments = static_cast<std::int32_t>(trajectory.segments.size());
  message.num_coefficients = kCoefficients * message.num_segments;
  for (const TrajectorySegment& segment : trajectory.segments) {
    message.duration_s.push_back(segment.duration_s);
    for (int k = 0; k < kCoefficients; ++k) {
      message.x_W.push_back(segment.coefficients(0, k));
      message.y_W.push_back(segment.coefficients(1, k));
      message.z_W.push_back(segment.coefficients(2, k));
      message.yaw_rad.push_back(segment.coefficients(3, k));
    }
  }
  return message;
}

Trajectory Decode(const citrine_lcm::trajectory_t& message) {
  Require(message.num_segments > 0, "trajectory_t: no segment");
  Require(message.x_W.size() == kCoefficients * message.duration_s.size(),
          "trajectory_t: num_coefficients is not 6 x num_segments");
  Require(message.trajectory_id >= 0 && message.path_id >= 0, "trajectory_t: trajectory_id or path_id < 0");
  Trajectory trajectory{message.trajectory_id, message.path_id, message.start_utime, {}};
  for (std::size_t i = 0; i < message.duration_s.size(); ++i) {
    TrajectorySegment segment;
    segment.duration_s = message.duration_s[i];
    RequireFinite("trajectory_t: a duration is not a number", segment.duration_s);
    Require(segment.duration_s >= 0, "trajectory_t: a duration < 0");
    for (int k = 0; k < kCoefficients; ++k) {
      const std::size_t at = kCoefficients * i + static_cast<std::size_t>(k);
      segment.coefficients.col(k) << message.x_W[at], message.y_W[at], message.z_W[at], message.yaw_rad[at];
    }
    Require(segment.coefficients.allFinite(), "trajectory_t: a coefficient is not finite");
    trajectory.segments.push_back(segment);
  }
  return trajectory;
}

}  // namespace citrine
