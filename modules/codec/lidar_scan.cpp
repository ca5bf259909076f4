#include "modules/codec/lidar_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
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
constexpr std::int32_t kMisfit = -2;     // for what is below any range or mark, or not a number
constexpr auto kMaxUnits = std::numeric_limits<std::int16_t>::max();
static_assert(std::endian::native == std::endian::little);  // as the ranges are on the wire

// Both ways without a branch, so that the compiler makes them work on many ranges at once.

/// Ranges in units of scale_m, and the marks as they are. @throws std::invalid_argument if one does not fit
std::vector<std::int16_t> Units(const std::vector<float>& ranges_m, double scale_m) {
  std::vector<std::int16_t> all(ranges_m.size());
  const double units_per_m = 1 / scale_m;
  std::int32_t least = 0, most = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float range_m = ranges_m[i];
    const double halves_up = range_m * units_per_m + 0.5;  // what is cut off then, is rounded
    auto units = static_cast<std::int32_t>(std::min(std::max(0.0, halves_up), kMaxUnits + 1.0));
    units = units == 0 ? 1 : units;  // a return never becomes none
    units = range_m >= 0 ? units : kMisfit;
    units = range_m == kNoReturn ? citrine_lcm::lidar_scan_t::NO_RETURN : units;
    units = range_m == kInvalid ? citrine_lcm::lidar_scan_t::INVALID : units;
    least = std::min(least, units);
    most = std::max(most, units);
    all[i] = static_cast<std::int16_t>(units);
  }
  if (least <= kMisfit || most > kMaxUnits) throw std::invalid_argument("a LiDAR range beyond the model's");
  return all;
}

/// The reverse. @param bytes  two a range
std::vector<float> Ranges_m(const std::vector<std::uint8_t>& bytes, double scale_m) {
  std::vector<float> ranges_m(bytes.size() / 2);
  std::int16_t least = 0;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    std::int16_t units;
    std::memcpy(&units, &bytes[2 * i], sizeof units);
    least = std::min(least, units);
    const auto range_m = static_cast<float>(units * scale_m);
    ranges_m[i] = range_m < 0 ? kInvalid : range_m;
  }
  Require(least >= citrine_lcm::lidar_scan_t::INVALID, "lidar_scan_t: a negative range");
  return ranges_m;
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
  const std::vector<std::int16_t> units = Units(scan.ranges_m, message.range_scale_m);
  message.ranges = Pack({reinterpret_cast<const std::uint8_t*>(units.data()), 2 * units.size()});
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
  scan.ranges_m =
      Ranges_m(Unpack(message.ranges, 2 * scan.model.num_beams(), "lidar_scan_t: ranges are not one a beam"),
               message.range_scale_m);
  return scan;
}

}  // namespace citrine
