#include "planner/view/dispersion.h"

#include <algorithm>
#include <cmath>

namespace citrine::planner {

namespace {
double SphereVolume(double radius_m) { return 4.0 / 3.0 * EIGEN_PI * radius_m * radius_m * radius_m; }
}  // namespace

double SphereOverlap(double radius_a_m, double radius_b_m, double distance_m) {
  const double sum = radius_a_m + radius_b_m, difference = radius_a_m - radius_b_m, d = distance_m;
  if (d >= sum) return 0;
  if (d <= std::abs(difference)) return SphereVolume(std::min(radius_a_m, radius_b_m));
  return EIGEN_PI * (sum - d) * (sum - d) * (d * d + 2 * d * sum - 3 * difference * difference) / (12 * d);
}

double Dispersion(const Eigen::Vector3d& view_W, const std::vector<Eigen::Vector3d>& others_W,
                  const QualityGoals& goals) {
  if (others_W.empty()) return 1;
  const double radius_m = goals.At(view_W).d_star_m;
  double common = 0;
  for (const Eigen::Vector3d& other_W : others_W)
    common += SphereOverlap(radius_m, goals.At(other_W).d_star_m, (view_W - other_W).norm());
  return 1 - common / (static_cast<double>(others_W.size()) * SphereVolume(goals.d_star_max()));
}

}  // namespace citrine::planner
