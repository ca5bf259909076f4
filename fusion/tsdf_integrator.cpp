#include "fusion/tsdf_integrator.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace citrine::fusion {
namespace {

constexpr float kFreeOnSurface =
    0.25f;  // share of a free observation's weight where a surface was seen before

/// Half the width in azimuth of a ball seen at an elevation; pi if it lies over a pole.
double HalfAzimuth(double elevation_rad, double half_angle_rad) {
  if (std::abs(elevation_rad) + half_angle_rad >= EIGEN_PI / 2 - 1e-3) return EIGEN_PI;
  return std::asin(std::min(1.0, std::sin(half_angle_rad) / std::cos(elevation_rad)));
}

}  // namespace

/// One scan, ready to be asked.
struct TsdfIntegrator::View {
  View(const LidarScan& scan, double voxel_m, double truncation_m)
      : image(scan, voxel_m),
        observer(image, voxel_m, truncation_m),
        R_SW(scan.X_WS.q.conjugate().toRotationMatrix()),
        p_WS(scan.X_WS.p) {}

  RangeImage image;
  VoxelObserver observer;
  Eigen::Matrix3d R_SW;
  Eigen::Vector3d p_WS;
};

std::vector<int> TsdfIntegrator::Integrate(const LidarScan& scan) {
  const VoxelGrid& grid = map_.grid();
  const View view(scan, grid.voxel_m(), map_.truncation_m());
  const double block_m = kBlockSide * grid.voxel_m(), block_radius_m = block_m * std::sqrt(0.75);
  const double reach_m = scan.model.range_max_m + map_.truncation_m();
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(reach_m);
  const auto block_at = [&](const Eigen::Vector3d& p_W) -> Eigen::Vector3i {
    return ((p_W - grid.origin_W()) / block_m).array().floor().cast<int>();
  };
  const Eigen::Vector3i first = block_at(view.p_WS - reach).cwiseMax(0);
  const Eigen::Vector3i last = block_at(view.p_WS + reach).cwiseMin((grid.blocks().array() - 1).matrix());

  std::vector<int> changed;
  std::unique_ptr<TsdfBlock> fresh;
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) {
        const VoxelIndex origin = kBlockSide * VoxelIndex(x, y, z);
        const Eigen::Vector3d centre_W =
            grid.origin_W() + (origin.cast<double>().array() + 0.5 * kBlockSide).matrix() * grid.voxel_m();
        const Eigen::Vector3d from_sensor_W = centre_W - view.p_WS;
        if (from_sensor_W.norm() > reach_m + block_radius_m) continue;
        float farthest_m = 0;
        const Sight sight = SightOf(view, view.R_SW * from_sensor_W, block_radius_m, &farthest_m);
        if (sight == Sight::kNone) continue;
        // A block is allocated only once something in it was observed.
        const int index = grid.Block(origin);
        TsdfBlock* block = map_.Find(index);
        if (!block && !fresh) fresh = std::make_unique<TsdfBlock>();
        TsdfBlock& target = block ? *block : *fresh;
        const bool any = sight == Sight::kFree ? Fill(target, 1 / (farthest_m * farthest_m))
                                               : Observe(view, origin, target);
        if (!any) continue;
        if (!block) {
          map_.Allocate(index) = *fresh;
          *fresh = TsdfBlock{};
        }
        changed.push_back(index);
      }
  if (policy_ == WeightPolicy::kPerPoint) CountPoints(scan, changed);
  return changed;
}

TsdfIntegrator::Sight TsdfIntegrator::SightOf(const View& view, const Eigen::Vector3d& centre_S,
                                              double radius_m, float* farthest_m) const {
  const LidarModel& model = view.image.model();
  const double distance_m = centre_S.norm();
  if (distance_m <= 1.05 * radius_m) return Sight::kMixed;
  const double half = std::asin(radius_m / distance_m);
  const double elevation = std::asin(centre_S.z() / distance_m),
               azimuth = std::atan2(centre_S.y(), centre_S.x());
  const double row_step = model.rows > 1 ? model.row_step_rad() : model.col_step_rad();
  const double low = (elevation - half - model.elevation_min_rad) / row_step;
  const double high = (elevation + half - model.elevation_min_rad) / row_step;
  if (high < -0.5 || low > model.rows - 0.5) return Sight::kNone;
  const double col = (azimuth + EIGEN_PI) / model.col_step_rad() - 0.5;
  const double half_cols = HalfAzimuth(elevation, half) / model.col_step_rad();
  const RangeBounds bounds = view.image.Bounds(
      static_cast<int>(std::floor(low)), static_cast<int>(std::floor(high)) + 1,
      static_cast<int>(std::floor(col - half_cols)), static_cast<int>(std::floor(col + half_cols)) + 1);
  const double truncation_m = map_.truncation_m();
  if (distance_m - radius_m > bounds.max_m + 2 * truncation_m) return Sight::kNone;
  const bool all_in_view = low >= 0 && high <= model.rows - 1;
  if (all_in_view && !bounds.any_invalid && distance_m + radius_m < bounds.min_m - 2 * truncation_m &&
      distance_m + radius_m < model.range_max_m) {
    *farthest_m = static_cast<float>(std::min<double>(bounds.max_m, model.range_max_m));
    return Sight::kFree;
  }
  return Sight::kMixed;
}

bool TsdfIntegrator::Fill(TsdfBlock& block, float weight) const {
  const auto truncation_m = static_cast<float>(map_.truncation_m());
  const Mask everywhere{_mm256_castsi256_ps(_mm256_set1_epi32(-1))};
  const Observation free{everywhere, Without(everywhere, everywhere), truncation_m, weight, 1.0f};
  bool any = false;
  for (int row = 0; row < kBlockSide * kBlockSide; ++row) any |= Fuse(free, row * kBlockSide, block);
  return any;
}

bool TsdfIntegrator::Observe(const View& view, const VoxelIndex& origin, TsdfBlock& block) const {
  const VoxelGrid& grid = map_.grid();
  const Eigen::Vector3f corner = (view.R_SW * (grid.Centre(origin) - view.p_WS)).cast<float>();
  const Eigen::Matrix3f step = (view.R_SW * grid.voxel_m()).cast<float>();
  const Lanes lane = _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7);
  bool any = false;
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y) {
      const Eigen::Vector3f first =
          corner + step.col(1) * static_cast<float>(y) + step.col(2) * static_cast<float>(z);
      const Observation observation =
          view.observer.Observe(Lanes(first.x()) + lane * step(0, 0), Lanes(first.y()) + lane * step(1, 0),
                                Lanes(first.z()) + lane * step(2, 0));
      if (observation.said.any()) any |= Fuse(observation, kBlockSide * (y + kBlockSide * z), block);
    }
  return any;
}

bool TsdfIntegrator::Fuse(const Observation& observation, int row, TsdfBlock& block) const {
  const Lanes distance = Load(&block.distance_m[row]), weight = Load(&block.weight[row]),
              quality = Load(&block.quality[row]);
  const auto truncation_m = static_cast<float>(map_.truncation_m());
  const Lanes codes_per_m = 127.0f / truncation_m;

  // A free ray seldom knows better than whoever saw a surface here from nearer by.
  const Lanes ratio = Min(observation.weight / Max(quality, 1e-9f), 1.0f);
  const Mask free_on_surface =
      Without(quality > 0.0f, observation.in_band) & (observation.sdf_m >= truncation_m);
  const Lanes share = Select(free_on_surface, ratio * ratio * kFreeOnSurface, 1.0f) * observation.share;
  const Lanes added = Select(observation.said, observation.weight * share, 0.0f);
  const Lanes sum = weight + added;
  const Lanes mean = (distance * weight + observation.sdf_m * added) / Max(sum, 1e-30f);
  const Lanes fused = Select(observation.said, Min(Max(mean, -truncation_m), truncation_m), distance);

  Lanes confidence = quality;
  if (policy_ == WeightPolicy::kBestView)
    confidence = Select(observation.in_band, Max(quality, observation.weight), quality);
  else if (policy_ == WeightPolicy::kPerScan)
    confidence = Select(observation.in_band, quality + observation.weight, quality);
  Store(&block.distance_m[row], fused);
  Store(&block.weight[row], sum);
  Store(&block.quality[row], confidence);

  const Mask first_seen = Without(sum > 0.0f, weight > 0.0f);
  const Mask moved = Round(fused * codes_per_m) != Round(distance * codes_per_m);
  return (first_seen | moved | (confidence != quality)).any();
}

void TsdfIntegrator::CountPoints(const LidarScan& scan, std::vector<int>& changed) {
  const VoxelGrid& grid = map_.grid();
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const float range_m = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
      if (!(range_m >= scan.model.range_min_m && range_m <= scan.model.range_max_m)) continue;
      const VoxelIndex voxel = grid.IndexOf(scan.X_WS * (scan.model.Direction(row, col) * range_m));
      if (!grid.Contains(voxel)) continue;
      const int index = grid.Block(voxel);
      TsdfBlock* block = map_.Find(index);
      const int at = VoxelGrid::InBlock(voxel);
      if (!block || !(block->weight[at] > 0)) continue;
      block->quality[at] += 1 / (range_m * range_m);
      changed.push_back(index);
    }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
}

}  // namespace citrine::fusion
