#include "planner/view/well_seen.h"

#include <cmath>

#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {
constexpr double kGrazing = 0.3;  ///< cosine between normal and line of sight
constexpr double kInside_rad = EIGEN_PI / 180;
}  // namespace

bool WellSeen(const PlanningMap& map, const Element& element, const SensorWindow& window,
              const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d to = element.p_W - p_W;
  const double distance = to.norm();
  if (distance > element.d_star_m || !window.InRange(distance)) return false;
  const double elevation = std::asin(to.z() / distance);
  if (elevation < window.elevation_min_rad() + kInside_rad ||
      elevation > window.elevation_max_rad() - kInside_rad)
    return false;
  if (!element.normal_W.isZero() && -element.normal_W.dot(to) < kGrazing * distance) return false;
  return LookAt(map, element, p_W, 0).clear;
}

std::vector<std::uint32_t> WellSeenFrom(const PlanningMap& map, const std::vector<Element>& elements,
                                        const SensorWindow& window, const Eigen::Vector3d& p_W) {
  std::vector<std::uint32_t> seen;
  for (const Element& element : elements)
    if (WellSeen(map, element, window, p_W)) seen.push_back(element.linear);
  return seen;
}

}  // namespace citrine::planner
