#include "sim/lidar/lidar_emulator.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/parallel_for.h"
#include "core/vehicle/airframe.h"

namespace citrine::sim {
namespace {

constexpr int kNoiseParts = 4;  ///< that threads take

/// Shortens the ranges of the beams that meet a sphere. @param to_centre_W  from the sensor to its centre
void SeeSphere(const Eigen::Vector3f& to_centre_W, float radius_m,
               const std::vector<Eigen::Vector3f>& directions_W, float range_max_m,
               std::vector<float>& ranges_m) {
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
  std::vector<Eigen::Vector3f> directions_W(directions_S_.size());
  std::ranges::transform(directions_S_, directions_W.begin(),
                         [&](const auto& d_S) { return Eigen::Vector3f(R_WS * d_S); });
  const auto range_max_m = static_cast<float>(model_.range_max_m);
  scene_->Cast(X_WS.p.cast<float>(), directions_W, range_max_m, scan.ranges_m);
  for (const Eigen::Vector3d& teammate_W : teammates_W)
    SeeSphere((teammate_W - X_WS.p).cast<float>(), static_cast<float>(kAirframeRadius_m), directions_W,
              range_max_m, scan.ranges_m);
  AddNoise(scan.ranges_m, random);
  return scan;
}

void LidarEmulator::AddNoise(std::vector<float>& ranges_m, Random& random) const {
  const auto range_min_m = static_cast<float>(model_.range_min_m),
             range_max_m = static_cast<float>(model_.range_max_m);
  const auto sigma_m = [this](float range_m) { return noise_m_per_m2_ * range_m * range_m; };
  // A part begins with the number that it would begin with if the beams before it had taken theirs.
  std::vector<std::uint32_t> numbers_before(ranges_m.size() + 1, 0);
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const bool noisy = std::isfinite(ranges_m[i]) && sigma_m(ranges_m[i]) > 0;
    numbers_before[i + 1] = numbers_before[i] + (noisy ? Random::kNumbersOfNormal : 0);
  }
  ParallelFor(static_cast<int>(ranges_m.size()), kNoiseParts, [&](int begin, int end) {
    Random own = random;
    own.Advance(numbers_before[static_cast<std::size_t>(begin)]);
    for (float& range : std::span(ranges_m).subspan(static_cast<std::size_t>(begin),
                                                    static_cast<std::size_t>(end - begin))) {
      if (!std::isfinite(range)) {
        range = kNoReturn;
        continue;
      }
      if (const double sigma = sigma_m(range); sigma > 0)
        range = std::min(range + static_cast<float>(sigma * own.Normal()), range_max_m);
      if (range < range_min_m) range = kInvalid;
    }
  });
  random.Advance(numbers_before.back());
}

}  // namespace citrine::sim
