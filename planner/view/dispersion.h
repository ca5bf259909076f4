#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/quality/quality_goal.h"

namespace citrine::planner {

/// Volume common to two spheres [m^3].
double SphereOverlap(double radius_a_m, double radius_b_m, double distance_m);

/// J_C of eq. (12): how little a view's sphere of influence meets those of the other UAVs' goals. 1 for a
/// fleet of one.
///
/// A sphere has the d* of the region that its centre lies in; the common denominator has the largest (section
/// IV-D).
/// @param others_W where each of the other N - 1 UAVs goes, or is if it goes nowhere
double Dispersion(const Eigen::Vector3d& view_W, const std::vector<Eigen::Vector3d>& others_W,
                  const QualityGoals& goals);

}  // namespace citrine::planner
