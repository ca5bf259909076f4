#pragma once

#include <vector>

#include "core/trajectory/trajectory.h"
#include "core/vehicle/vehicle_limits.h"

namespace citrine::planner {

enum class Braking { kGentle, kHard };

/// Comes to rest along a motion from an instant on: the same way, ever slower. Position, velocity and
/// acceleration continue exactly; kHard decelerates at 0.95 of the limit after a ramp of 0.2 s, kGentle
/// evenly (4.5 m/s: 3.4 m); slower where the motion itself turns or slows down, so that all in all stays
/// within the limit. A motion that ends sooner by itself is followed to its end.
std::vector<TrajectorySegment> BrakeAlong(const Trajectory& flown, Utime at, const VehicleLimits& limits,
                                          Braking braking);

/// [m] way that braking hard from a speed takes: 2.7 m from 4.5 m/s.
double StoppingDistance(double speed_mps, const VehicleLimits& limits);

/// The motion that goes straight on from a state, its acceleration fading: to brake along when the way ahead
/// is blocked.
Trajectory Onward(const TrajectoryPoint& state, Utime at);

}  // namespace citrine::planner
