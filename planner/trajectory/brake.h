#pragma once

#include <vector>

#include "core/trajectory/trajectory.h"
#include "core/vehicle/vehicle_limits.h"

namespace citrine::planner {

enum class Braking { kGentle, kHard };

/// Comes to rest along a motion from an instant on: the same way, ever slower. Position, velocity and
/// acceleration continue exactly; kHard decelerates as hard as the limits allow after a ramp of 0.15 s (4.5
/// m/s: 2.4 m), kGentle evenly (3.2 m). A motion that ends sooner by itself is followed to its end.
std::vector<TrajectorySegment> BrakeAlong(const Trajectory& flown, Utime at, const VehicleLimits& limits,
                                          Braking braking);

/// The motion that goes straight on from a state, its acceleration fading: to brake along when the way ahead
/// is blocked.
Trajectory Onward(const TrajectoryPoint& state, Utime at);

}  // namespace citrine::planner
