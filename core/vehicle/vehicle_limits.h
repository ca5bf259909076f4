#pragma once

namespace citrine {

/// What a trajectory may ask of a UAV (paper, table I).
struct VehicleLimits {
  double radius_m = 1.0;  ///< clearance that the UAV's centre keeps from every obstacle
  double speed_max_mps = 4.5;
  double acceleration_max_mps2 = 4.8;
};

}  // namespace citrine
