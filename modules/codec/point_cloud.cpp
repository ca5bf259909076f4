#include "modules/codec/point_cloud.h"

#include <algorithm>
#include <cstring>

#include "modules/codec/bad_message.h"
#include "modules/codec/geometry.h"

namespace citrine {
namespace {

constexpr std::size_t kPointBytes = 3 * sizeof(float);
constexpr std::size_t kPointsAChunk = 2700;

}  // namespace

std::vector<citrine_lcm::point_cloud_t> EncodeInMessages(const PointCloud& cloud) {
  const std::size_t count =
      std::max<std::size_t>(1, (cloud.points_S.size() + kPointsAChunk - 1) / kPointsAChunk);
  std::vector<citrine_lcm::point_cloud_t> messages;
  for (std::size_t i = 0; i < count; ++i) {
    citrine_lcm::point_cloud_t message{};
    message.measured_utime = cloud.measured;
    EncodePose(cloud.X_WS, message.p_WS, message.q_WS);
    message.range_min_m = cloud.range_min_m;
    message.range_max_m = cloud.range_max_m;
    message.chunk = static_cast<std::int32_t>(i);
    message.num_chunks = static_cast<std::int32_t>(count);
    const std::size_t first = i * kPointsAChunk;
    const std::size_t points = std::min(kPointsAChunk, cloud.points_S.size() - first);
    message.num_points = static_cast<std::int32_t>(points);
    message.points.resize(points * kPointBytes);
    if (points > 0) std::memcpy(message.points.data(), cloud.points_S[first].data(), message.points.size());
    message.num_bytes = static_cast<std::int32_t>(message.points.size());
    messages.push_back(std::move(message));
  }
  return messages;
}

PointCloud Decode(const citrine_lcm::point_cloud_t& message) {
  RequireFinite("point_cloud_t: a range is not a number", message.range_min_m, message.range_max_m);
  Require(message.range_min_m >= 0 && message.range_min_m < message.range_max_m,
          "point_cloud_t: range_min_m and range_max_m contradict each other");
  Require(message.chunk >= 0 && message.chunk < message.num_chunks,
          "point_cloud_t: chunk outside num_chunks");
  Require(message.num_points >= 0 &&
              message.points.size() == kPointBytes * static_cast<std::size_t>(message.num_points),
          "point_cloud_t: num_bytes is not 12 x num_points");
  PointCloud cloud;
  cloud.measured = message.measured_utime;
  cloud.X_WS = DecodePose(message.p_WS, message.q_WS, "point_cloud_t: X_WS is not a pose");
  cloud.range_min_m = message.range_min_m;
  cloud.range_max_m = message.range_max_m;
  cloud.points_S.resize(static_cast<std::size_t>(message.num_points));
  if (!message.points.empty())
    std::memcpy(cloud.points_S.data()->data(), message.points.data(), message.points.size());
  for (const Eigen::Vector3f& p_S : cloud.points_S)
    Require(p_S.allFinite(), "point_cloud_t: a point is not finite");
  return cloud;
}

}  // namespace citrine
