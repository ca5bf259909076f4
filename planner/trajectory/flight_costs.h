#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/map/distance_field.h"
#include "core/trajectory/trajectory.h"

namespace citrine::planner {

/// One sample of a motion, or derivatives of a cost by it; `t_s` in seconds since the motion began.
struct FlightSample {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d j = Eigen::Vector3d::Zero();
  double t_s = 0;
};

/// Another UAV's committed motion, and how far to stay away from it.
struct Teammate {
  int uav = 0;
  Trajectory trajectory;
};

// Rates of cost: what a motion pays a second. Each is the cube of a hinge, twice differentiable and zero
// where all is well, and adds its derivatives to `by` times `weight`.

/// Clearance missing in a distance field [m]: to what is occupied, or to what is unknown.
double ClearanceCost(const DistanceField& field, double clearance_m, const FlightSample& x, double weight,
                     FlightSample* by);
/// Excess of |v|^2 over its limit, relative to it.
double SpeedCost(double speed_max_mps, const FlightSample& x, double weight, FlightSample* by);
/// The same of |a|^2.
double AccelerationCost(double acceleration_max_mps2, const FlightSample& x, double weight, FlightSample* by);
/// The same of |jerk|^2.
double JerkCost(double jerk_max_mps3, const FlightSample& x, double weight, FlightSample* by);
/// Way outside of a box [m], every axis by itself.
double VolumeCost(const Eigen::AlignedBox3d& box_W, const FlightSample& x, double weight, FlightSample* by);
/// Closeness to a teammate at the same time: excess of separation^2 over distance^2, relative to it.
/// @param start when the motion began
double TeammateCost(const Teammate& teammate, double separation_m, Utime start, const FlightSample& x,
                    double weight, FlightSample* by);

}  // namespace citrine::planner
