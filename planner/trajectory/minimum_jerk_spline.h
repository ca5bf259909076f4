#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/trajectory/trajectory.h"

namespace citrine::planner {

/// Position, velocity, acceleration at one knot, or derivatives of a cost by them.
struct Knot {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
};

/// Quintic pieces through given points that minimise the integral of squared jerk.
///
/// Points and durations are the only variables: the velocities and accelerations at inner knots follow from a
/// linear system, block-tridiagonal with 2x2 blocks and the same for every axis (after Richter et al. 2013;
/// Wang et al. 2022).
class MinimumJerkSpline {
 public:
  /// Keeps the first and the last knot whole and the positions of the inner ones, and finds their v and a.
  /// @param durations_s one fewer than knots, all positive
  void Solve(std::vector<Knot> knots, std::vector<double> durations_s);

  const std::vector<Knot>& knots() const { return knots_; }
  const std::vector<double>& durations_s() const { return durations_s_; }

  /// [m^2/s^5] integral of the squared jerk; adds its partial derivatives if asked.
  double JerkEnergy(std::vector<Knot>* by_knot = nullptr, std::vector<double>* by_duration = nullptr) const;

  /// Partial derivatives of a cost by every knot's state and every duration -> its total derivatives by the
  /// positions
  /// (`by_knot[i].p` of inner knots) and durations, through the linear system (adjoint method).
  void PullBack(std::vector<Knot>* by_knot, std::vector<double>* by_duration) const;

  /// The pieces as polynomials; yaw stays zero.
  std::vector<TrajectorySegment> Segments() const;

 private:
  struct Block {
    double vv, va, av, aa;
  };
  void Factor();
  /// Solves 2H y = r in place; r and y are (v, a) of the inner knots.
  void SolveInner(std::vector<Knot>* r) const;

  std::vector<Knot> knots_;
  std::vector<double> durations_s_;
  std::vector<Block> inverse_, upper_;  ///< block Thomas: inverted pivots, and couplings to the next knot
};

/// The quintic from one knot to another as a piece of a trajectory; yaw stays zero.
TrajectorySegment Quintic(const Knot& from, const Knot& to, double duration_s);

}  // namespace citrine::planner
