#include "planner/view/navigation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace citrine::planner {

double Alignment(const Eigen::Vector3d& velocity_W, const Eigen::Vector3d& to_view_W) {
  const double speed = velocity_W.norm(), distance = to_view_W.norm();
  if (speed < 0.1 || distance < 1e-9) return 1;
  const double cosine = std::clamp(velocity_W.dot(to_view_W) / (speed * distance), -1.0, 1.0);
  return 1 - std::acos(cosine) / EIGEN_PI;
}

std::vector<double> NavigationScores(const std::vector<View>& views, const Eigen::Vector3d& p_W,
                                     const Eigen::Vector3d& velocity_W, double voxel_m) {
  std::vector<double> scores(views.size());
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < views.size(); ++i) {
    scores[i] = std::max((views[i].p_W - p_W).norm(), voxel_m);
    nearest = std::min(nearest, scores[i]);
  }
  for (std::size_t i = 0; i < views.size(); ++i)
    scores[i] = Alignment(velocity_W, views[i].p_W - p_W) * nearest / scores[i];
  return scores;
}

}  // namespace citrine::planner
