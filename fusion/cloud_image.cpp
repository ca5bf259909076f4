#include "fusion/cloud_image.h"

#include <algorithm>
#include <cmath>

namespace citrine::fusion {
namespace {

constexpr int kMostRings = 160, kLeastPointsARing = 16, kMostRows = 256, kMostCols = 4096;
constexpr double kDegree = EIGEN_PI / 180, kRingGap_rad = 0.08 * kDegree;

double Elevation(const Eigen::Vector3f& p_S) { return std::atan2(p_S.z(), p_S.head<2>().norm()); }
double Azimuth(const Eigen::Vector3f& p_S) { return std::atan2(p_S.y(), p_S.x()); }

/// Azimuths of points whose elevations lie together.
struct Ring {
  double elevation_rad;
  std::vector<double> azimuths_rad;
};

/// Points sorted by elevation, cut where there is a gap.
std::vector<Ring> RingsOf(std::vector<Eigen::Vector3f> points_S) {
  std::vector<std::pair<double, double>> angles;
  for (const Eigen::Vector3f& p_S : points_S) angles.emplace_back(Elevation(p_S), Azimuth(p_S));
  std::sort(angles.begin(), angles.end());
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (i == 0 || angles[i].first - angles[i - 1].first > kRingGap_rad) rings.push_back({0, {}});
    rings.back().elevation_rad += angles[i].first;
    rings.back().azimuths_rad.push_back(angles[i].second);
  }
  for (Ring& ring : rings) ring.elevation_rad /= static_cast<double>(ring.azimuths_rad.size());
  std::erase_if(rings, [](const Ring& ring) { return ring.azimuths_rad.size() < kLeastPointsARing; });
  return rings;
}

/// Whether rings are so far apart that all lie within a third of a step of even ones.
bool Even(const std::vector<Ring>& rings) {
  const double step =
      (rings.back().elevation_rad - rings.front().elevation_rad) / static_cast<double>(rings.size() - 1);
  for (std::size_t i = 0; i < rings.size(); ++i)
    if (std::abs(rings.front().elevation_rad + step * static_cast<double>(i) - rings[i].elevation_rad) >
        step / 3)
      return false;
  return true;
}

/// Median step from a point of a ring to the next.
double ColumnStep(std::vector<Ring> rings) {
  std::vector<double> steps;
  for (Ring& ring : rings) {
    std::sort(ring.azimuths_rad.begin(), ring.azimuths_rad.end());
    for (std::size_t i = 1; i < ring.azimuths_rad.size(); ++i)
      steps.push_back(ring.azimuths_rad[i] - ring.azimuths_rad[i - 1]);
  }
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

}  // namespace

LidarScan Binned(const PointCloud& cloud, const LidarModel& model) {
  LidarScan scan{.measured = cloud.measured, .X_WS = cloud.X_WS, .model = model, .ranges_m = {}};
  scan.model.range_min_m = cloud.range_min_m;
  scan.model.range_max_m = cloud.range_max_m;
  scan.ranges_m.assign(model.num_beams(), kInvalid);
  const double row_step = model.rows > 1 ? model.row_step_rad() : model.col_step_rad();
  for (const Eigen::Vector3f& p_S : cloud.points_S) {
    const float range_m = p_S.norm();
    if (!(range_m >= cloud.range_min_m && range_m <= cloud.range_max_m)) continue;
    const auto row = static_cast<int>(std::lround((Elevation(p_S) - model.elevation_min_rad) / row_step));
    if (row < 0 || row >= model.rows) continue;
    const auto col = static_cast<int>((Azimuth(p_S) + EIGEN_PI) / model.col_step_rad()) % model.cols;
    float& nearest_m = scan.ranges_m[static_cast<std::size_t>(row) * model.cols + col];
    if (nearest_m < 0 || range_m < nearest_m) nearest_m = range_m;
  }
  return scan;
}

LidarModel GuessModel(const std::vector<Eigen::Vector3f>& points_S, double range_min_m, double range_max_m) {
  std::vector<Eigen::Vector3f> within;
  std::copy_if(points_S.begin(), points_S.end(), std::back_inserter(within), [&](const Eigen::Vector3f& p_S) {
    return p_S.norm() >= range_min_m && p_S.norm() <= range_max_m;
  });
  LidarModel model;
  model.range_min_m = range_min_m;
  model.range_max_m = range_max_m;
  model.rows = 0;
  if (within.empty()) return model;
  const std::vector<Ring> rings = RingsOf(within);
  if (rings.size() >= 2 && rings.size() <= kMostRings && Even(rings)) {
    model.rows = static_cast<int>(rings.size());
    model.elevation_min_rad = rings.front().elevation_rad;
    model.elevation_max_rad = rings.back().elevation_rad;
    model.cols = std::clamp(static_cast<int>(std::lround(2 * EIGEN_PI / ColumnStep(rings))), 8, kMostCols);
    return model;
  }
  const auto [lowest, highest] = std::minmax_element(
      within.begin(), within.end(), [](const auto& a, const auto& b) { return Elevation(a) < Elevation(b); });
  model.elevation_min_rad = Elevation(*lowest);
  model.elevation_max_rad = std::max(Elevation(*highest), model.elevation_min_rad + kDegree);
  const double solid_angle =
      2 * EIGEN_PI * (std::sin(model.elevation_max_rad) - std::sin(model.elevation_min_rad));
  const double step = std::sqrt(solid_angle / static_cast<double>(within.size()));
  model.rows =
      std::clamp(static_cast<int>(std::ceil((model.elevation_max_rad - model.elevation_min_rad) / step)) + 1,
                 2, kMostRows);
  model.cols = std::clamp(static_cast<int>(std::ceil(2 * EIGEN_PI / step)), 8, kMostCols);
  return model;
}

}  // namespace citrine::fusion
