#include "modules/codec/lidar_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "modules/codec/bad_message.h"
#include "modules/codec/geometry.h"
#include "modules/codec/packed_bytes.h"

namespace citrine {
namespace {

constexpr double kFinestScale_m = 1e-3;  // well below the sensor's noise, and 32 m fit into an int16
constexpr int kLargestModel = 1 << 22;   // beams; a larger product of rows and columns is no sensor's
constexpr auto kMaxUnits = std::numeric_limits<std::int16_t>::max();

std::int16_t Units(float range_m, double scale_m) {
  if (range_m == kNoReturn) return citrine_lcm::lidar_scan_t::NO_RETURN;
  if (range_m == kInvalid) return citrine_lcm::lidar_scan_t::INVALID;
  const double units = std::round(range_m / scale_m);
  if (!(units >= 0 && units <= kMaxUnits)) throw std::invalid_argument("a LiDAR range beyond the model's");
  return static_cast<std::int16_t>(std::max(units, 1.0));
}

}  // namespace

citrine_lcm::lidar_scan_t Encode(const LidarScan& scan) {
  if (scan.ranges_m.size() != scan.model.num_beams())
    throw std::invalid_argument("a LiDAR scan needs one range a beam");
  citrine_lcm::lidar_scan_t message{};
  message.measured_utime = scan.measured;
  EncodePose(scan.X_WS, message.p_WS, message.q_WS);
  message.elevation_min_rad = scan.model.elevation_min_rad;
  message.elevation_max_rad = scan.model.elevation_max_rad;
  message.range_min_m = scan.model.range_min_m;
  message.range_max_m = scan.model.range_max_m;
  message.range_scale_m = std::max(kFinestScale_m, scan.model.range_max_m / 32000);
  message.num_rows = scan.model.rows;
  message.num_cols = scan.model.cols;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * scan.ranges_m.size());
  for (const float range_m : scan.ranges_m) {
    const auto units = static_cast<std::uint16_t>(Units(range_m, message.range_scale_m));
    bytes.push_back(static_cast<std::uint8_t>(units & 0xff));
    bytes.push_back(static_cast<std::uint8_t>(units >> 8));
  }
  message.ranges = Pack(bytes);
  message.num_bytes = static_cast<std::int32_t>(message.ranges.size());
  return message;
}

LidarScan Decode(const citrine_lcm::lidar_scan_t& message) {
  LidarScan scan;
  scan.measured = message.measured_utime;
  scan.X_WS = DecodePose(message.p_WS, message.q_WS, "lidar_scan_t: X_WS is not a pose");
  RequireFinite("lidar_scan_t: a limit of the model is not a number", message.elevation_min_rad,
                message.elevation_max_rad, message.range_min_m, message.range_max_m, message.range_scale_m);
  Require(message.elevation_min_rad <= message.elevation_max_rad && message.range_min_m > 0 &&
              message.range_min_m < message.range_max_m && message.range_scale_m > 0,
          "lidar_scan_t: the limits of the model contradict each other");
  Require(
      message.num_rows > 0 && message.num_cols > 0 && message.num_rows <= kLargestModel / message.num_cols,
      "lidar_scan_t: num_rows or num_cols out of range");
  scan.model = {message.num_rows,          message.num_cols,    message.elevation_min_rad,
                message.elevation_max_rad, message.range_min_m, message.range_max_m};
  const auto bytes =
      Unpack(message.ranges, 2 * scan.model.num_beams(), "lidar_scan_t: ranges are not one a beam");
  scan.ranges_m.reserve(scan.model.num_beams());
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const auto units = static_cast<std::int16_t>(bytes[i] | bytes[i + 1] << 8);
    Require(units >= message.INVALID, "lidar_scan_t: a negative range");
    scan.ranges_m.push_back(units == message.INVALID ? kInvalid
                                                     : static_cast<float>(units * message.range_scale_m));
  }
  return scan;
}

}  // namespace citrine
