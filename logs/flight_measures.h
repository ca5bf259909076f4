#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "logs/flight_record.h"

namespace citrine::logs {

/// Numbers over a flight: (mission time [s], value).
using Series = std::vector<std::pair<double, double>>;

/// [m] from a point to the nearest obstacle of the true world.
using Clearance = std::function<double(const Eigen::Vector3d& p_W)>;

/// [m] flown: the sum of the distances between recorded positions.
double PathLength(const std::vector<UavState>& states);
Series PathLengthOverTime(const std::vector<UavState>& states);

Series SpeedOverTime(const std::vector<UavState>& states);

/// [m/s^2] of the true vehicle: difference of recorded velocities 0.1 s apart, over 0.1 s. A mean over that
/// window, so that one step of the physics engine does not count as a jerk of the vehicle.
Series AccelerationOverTime(const std::vector<UavState>& states);

/// [m] from each UAV's centre to the nearest of the others' that have spoken of the same instant. Empty for
/// one alone.
std::vector<Series> SeparationOverTime(const std::vector<UavFlight>& uavs);

/// [m/s] mean speed of all UAVs over the instants at which a path is under way (tracked, braked or blocked,
/// not yet reached).
std::optional<double> MeanSpeedUnderWay(const std::vector<UavFlight>& uavs);

/// [m] clearance of a UAV's centre.
Series ClearanceOverTime(const std::vector<UavState>& states, const Clearance& clearance);

/// Contacts counted by the simulator, all UAVs.
int Collisions(const std::vector<UavFlight>& uavs);
/// Decisions made, all UAVs.
std::int64_t Decisions(const std::vector<UavFlight>& uavs);

/// Elements that the UAV that knows of most has last counted as given up, or as unreachable.
int ElementsGivenUp(const std::vector<UavFlight>& uavs);
int ElementsUnreachable(const std::vector<UavFlight>& uavs);

/// The newest value at a time [s]; 0 before the first.
double ValueAt(const Series& series, double time_s);

/// Largest value; nothing if empty. Smallest likewise, of one series or of all.
std::optional<double> MaxOf(const Series& series);
std::optional<double> MinOf(const Series& series);
std::optional<double> MinOf(const std::vector<Series>& all);

}  // namespace citrine::logs
