#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/trajectory/flight_objective.h"

namespace citrine::planner {

/// The first thing that is wrong with a motion.
struct Violation {
  enum class Kind { kJump, kSpeed, kAcceleration, kVolume, kOccupied, kUnknown, kTeammate, kNoRest };
  Kind kind;
  Utime at = 0;
  double value = 0;  ///< what was found: m/s, m/s^2 or m
  int teammate = 0;  ///< for kTeammate

  std::string Reason() const;
};

/// The hard check before a motion is committed, and of what is left of a committed one: steady, within the
/// limits, the robot's radius away from everything occupied and unknown wherever it goes and where it
/// ends, and apart from every teammate at all times, the rest at both ends included.
///
/// A clearance that is short where the motion begins must not shrink further until it is whole again.
/// @param from what lies before it is not checked
std::optional<Violation> FindViolation(const Trajectory& trajectory, Utime from, const FlightScene& scene);

/// The part of it that is about the map alone.
std::optional<Violation> FindMapViolation(const Trajectory& trajectory, Utime from, const FlightScene& scene);

/// The part of it that is about one teammate.
std::optional<Violation> FindConflict(const Trajectory& trajectory, Utime from, const Teammate& teammate,
                                      double separation_m);

}  // namespace citrine::planner
