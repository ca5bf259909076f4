#pragma once

#include <vector>

#include "core/config/mission_config.h"
#include "core/map/planning_map.h"
#include "core/vehicle/vehicle_limits.h"
#include "planner/trajectory/flight_costs.h"
#include "planner/trajectory/minimum_jerk_spline.h"
#include "planner/trajectory/whereabouts.h"

namespace citrine::planner {

/// What flying badly costs, relative to a unit of jerk energy.
struct FlightWeights {
  FlightWeights() : FlightWeights(SmootherSection()) {}
  explicit FlightWeights(const SmootherSection& section)
      : time(section.weight_time),
        clearance(section.weight_clearance),
        limits(section.weight_limits),
        teammates(section.weight_clearance) {}

  double time;       ///< a second
  double clearance;  ///< to occupied and to unknown, and to the volume's faces
  double limits;     ///< of speed and acceleration
  double teammates;
};

/// What a motion has to respect. The map outlives it.
struct FlightScene {
  const PlanningMap* map = nullptr;
  VehicleLimits limits;
  std::vector<Teammate> teammates;

  /// [m] distance kept between two UAVs' centres.
  double separation_m() const { return 2 * limits.radius_m + 0.2; }
};

/// The cost of a minimum-jerk spline as a function of its inner points and the logarithms of its durations,
/// with its exact gradient: jerk + time + penalties sampled along the pieces.
class FlightObjective {
 public:
  /// @param start first knot, kept; @param end last knot, kept
  FlightObjective(const FlightScene& scene, const FlightWeights& weights, const Knot& start, const Knot& end,
                  Utime begins);

  /// @param x inner points (x, y, z each), then log durations
  /// @param gradient same size, or null
  double Evaluate(const std::vector<double>& x, std::vector<double>* gradient);

  /// The spline of the last evaluation.
  const MinimumJerkSpline& spline() const { return spline_; }

  static std::vector<double> Pack(const std::vector<Eigen::Vector3d>& inner_W,
                                  const std::vector<double>& durations_s);

 private:
  double SamplePieces(std::vector<Knot>* by_knot, std::vector<double>* by_duration) const;
  double RateOfCost(const FlightSample& x, double weight, FlightSample* by) const;

  const FlightScene& scene_;
  FlightWeights weights_;
  Knot start_, end_;
  Utime begins_;
  std::vector<Whereabouts> whereabouts_;  ///< of the scene's teammates
  MinimumJerkSpline spline_;
};

/// Shares of the limits that are planned for: time presses motions beyond them by a few per cent.
inline constexpr double kPlannedSpeed = 0.96;
inline constexpr double kPlannedAcceleration = 0.94;

}  // namespace citrine::planner
