#include <algorithm>
#include <cmath>
#include <map>

#include "sim/lidar/observability.h"

namespace citrine::sim {
namespace {

constexpr float kCell_m = 1.0f;

/// Samples that nobody has seen yet, in cubes of 1 m.
class Unseen {
 public:
  explicit Unseen(const std::vector<SurfaceSample>& samples) : samples_(samples) {
    for (const SurfaceSample& sample : samples) box_.extend(sample.p_W);
    if (samples.empty()) return;
    size_ = ((box_.sizes() / kCell_m).array().floor().cast<int>() + 1).matrix();
    cells_.resize(static_cast<std::size_t>(size_.prod()));
    for (std::size_t i = 0; i < samples.size(); ++i)
      cells_[Linear(CellOf(samples[i].p_W))].push_back(static_cast<int>(i));
  }

  /// Calls `visit` with every cell that a ball touches.
  template <class Visit>
  void ForCellsNear(const Eigen::Vector3f& centre_W, float radius_m, Visit visit) {
    if (cells_.empty()) return;
    const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius_m);
    const Eigen::Vector3i low = CellOf(centre_W - reach).cwiseMax(0),
                          high = CellOf(centre_W + reach).cwiseMin((size_.array() - 1).matrix());
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x)
          if (auto& cell = cells_[Linear({x, y, z})]; !cell.empty()) visit(cell);
  }

 private:
  Eigen::Vector3i CellOf(const Eigen::Vector3f& p_W) const {
    return ((p_W - box_.min()) / kCell_m).array().floor().cast<int>();
  }
  std::size_t Linear(const Eigen::Vector3i& c) const {
    return static_cast<std::size_t>(c.x()) +
           static_cast<std::size_t>(size_.x()) * (c.y() + static_cast<std::size_t>(size_.y()) * c.z());
  }

  const std::vector<SurfaceSample>& samples_;
  Eigen::AlignedBox3f box_;
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<std::vector<int>> cells_;
};

}  // namespace

std::vector<int> FirstSeenBy(const std::vector<SurfaceSample>& samples, const std::vector<Pose>& X_WS,
                             const RayScene& scene, const LidarModel& model, const QualityGoals& goals) {
  const auto reach_m = static_cast<float>(std::min(goals.d_star_max(), model.range_max_m));
  const double sin_min = std::sin(model.elevation_min_rad), sin_max = std::sin(model.elevation_max_rad);
  std::vector<float> goal_m;
  for (const SurfaceSample& sample : samples)
    goal_m.push_back(
        static_cast<float>(std::min(goals.At(sample.p_W.cast<double>()).d_star_m, model.range_max_m)));
  std::vector<int> first(samples.size(), -1);
  std::vector<std::uint8_t> free;
  std::vector<Eigen::Vector3f> from_W, target_W;
  std::vector<int> candidates;
  Unseen unseen(samples);
  for (std::size_t scan = 0; scan < X_WS.size(); ++scan) {
    const Pose& pose = X_WS[scan];
    const Eigen::Vector3f p_W = pose.p.cast<float>(),
                          up_W = (pose.q * Eigen::Vector3d::UnitZ()).cast<float>();
    candidates.clear();
    target_W.clear();
    unseen.ForCellsNear(p_W, reach_m, [&](std::vector<int>& cell) {
      std::erase_if(cell, [&](int i) { return first[i] >= 0; });
      for (const int i : cell) {
        const Eigen::Vector3f ray = samples[i].p_W - p_W;
        const float range_m = ray.norm(), z_S = ray.dot(up_W);
        if (range_m > goal_m[i] || range_m < model.range_min_m || z_S < sin_min * range_m ||
            z_S > sin_max * range_m)
          continue;
        candidates.push_back(i);
        target_W.push_back(samples[i].p_W);
      }
    });
    from_W.assign(candidates.size(), p_W);
    free.resize(candidates.size());
    scene.Unoccluded(from_W, target_W, free);
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (free[k] != 0) first[candidates[k]] = static_cast<int>(scan);
  }
  return first;
}

}  // namespace citrine::sim
