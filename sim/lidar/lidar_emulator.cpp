#include "sim/lidar/lidar_emulator.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/parallel_for.h"
#include "core/vehicle/airframe.h"

namespace citrine::sim {
namespace {

constexpr int kParts = 8;  ///< of the beams, that threads take

/// Shortens the ranges of the beams that meet a sphere. @param to_centre_W  from the sensor to its centre
void SeeSphere(const Eigen::Vector3f& to_centre_W, float radius_m,
               std::span<const Eigen::Vector3f> directions_W, float range_max_m, std::span<float> ranges_m) {
  const float distance_sq = to_centre_W.squaredNorm(), radius_sq = radius_m * radius_m;
  if (distance_sq <= radius_sq || distance_sq > (range_max_m + radius_m) * (range_max_m + radius_m)) return;
  for (std::size_t i = 0; i < directions_W.size(); ++i) {
    const float along = to_centre_W.dot(directions_W[i]);
    const float half_chord_sq = radius_sq - (distance_sq - along * along);
    if (along <= 0 || half_chord_sq < 0) continue;
    const float range = along - std::sqrt(half_chord_sq);
    if (range <= range_max_m) ranges_m[i] = std::min(ranges_m[i], range);
  }
}

template <class T>
std::span<T> BeamsOf(std::vector<T>& all, int begin, int end) {
  return std::span(all).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
}

}  // namespace

LidarEmulator::LidarEmulator(std::shared_ptr<const RayScene> scene, const LidarModel& model,
                             double noise_m_per_m2)
    : scene_(std::move(scene)), model_(model), noise_m_per_m2_(noise_m_per_m2) {
  for (int row = 0; row < model_.rows; ++row)
    for (int col = 0; col < model_.cols; ++col)
      directions_S_.push_back(model_.Direction(row, col).cast<float>());
}

LidarScan LidarEmulator::Scan(Utime utime, const Pose& X_WS, const std::vector<Eigen::Vector3d>& teammates_W,
                              Random& random) const {
  LidarScan scan{utime, X_WS, model_, std::vector<float>(directions_S_.size())};
  const Eigen::Matrix3f R_WS = X_WS.q.toRotationMatrix().cast<float>();
  const Eigen::Vector3f p_WS = X_WS.p.cast<float>();
  const auto range_max_m = static_cast<float>(model_.range_max_m);
  std::vector<Eigen::Vector3f> directions_W(directions_S_.size());
  ParallelFor(static_cast<int>(directions_S_.size()), kParts, [&](int begin, int end) {
    const std::span<float> ranges_m = BeamsOf(scan.ranges_m, begin, end);
    const std::span<Eigen::Vector3f> part_W = BeamsOf(directions_W, begin, end);
    std::transform(directions_S_.begin() + begin, directions_S_.begin() + end, part_W.begin(),
                   [&](const auto& d_S) { return Eigen::Vector3f(R_WS * d_S); });
    scene_->Cast(p_WS, part_W, range_max_m, ranges_m);
    for (const Eigen::Vector3d& teammate_W : teammates_W)
      SeeSphere((teammate_W - X_WS.p).cast<float>(), static_cast<float>(kAirframeRadius_m), part_W,
                range_max_m, ranges_m);
  });
  AddNoise(scan.ranges_m, random);
  return scan;
}

void LidarEmulator::AddNoise(std::vector<float>& ranges_m, Random& random) const {
  const auto range_min_m = static_cast<float>(model_.range_min_m),
             range_max_m = static_cast<float>(model_.range_max_m);
  const auto sigma_m = [this](float range_m) { return noise_m_per_m2_ * range_m * range_m; };
  std::vector<float*> noisy(ranges_m.size());
  std::size_t count = 0;
  for (float& range : ranges_m) {
    noisy[count] = &range;
    count += std::isfinite(range) && sigma_m(range) > 0;
  }
  noisy.resize(count);
  ParallelFor(static_cast<int>(noisy.size()), kParts, [&](int begin, int end) {
    // A part begins with the number that it would begin with if the beams before it had taken theirs.
    Random own = random;
    own.Advance(static_cast<std::uint64_t>(begin) * Random::kNumbersOfNormal);
    std::vector<double> normals(static_cast<std::size_t>(end - begin));
    own.Normals(normals);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      float& range = *noisy[static_cast<std::size_t>(begin) + i];
      range = std::min(range + static_cast<float>(sigma_m(range) * normals[i]), range_max_m);
    }
  });
  random.Advance(noisy.size() * Random::kNumbersOfNormal);
  for (float& range : ranges_m)
    range = !std::isfinite(range) ? kNoReturn : range < range_min_m ? kInvalid : range;
}

}  // namespace citrine::sim
