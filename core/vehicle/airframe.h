#pragma once

namespace citrine {

/// [m] radius of the sphere that a UAV's airframe fills: what the other UAVs' LiDARs see and what collides.
/// Not to be confused with the clearance that its centre keeps (VehicleLimits::radius_m).
inline constexpr double kAirframeRadius_m = 0.35;

}  // namespace citrine
