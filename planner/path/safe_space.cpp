#include "planner/path/safe_space.h"

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace citrine::planner {

namespace {

constexpr double kStepMin_m = 0.06;  ///< of sphere tracing: a quarter of the paper's voxel
constexpr double kTolerance_m = 1e-6;
constexpr double kRoomy_m = 0.5;

std::uint16_t SquaredVoxels(double distance_m, double voxel_m) {
  const double n = distance_m / voxel_m;
  return static_cast<std::uint16_t>(std::min(65535.0, std::ceil(n * n - 1e-6)));
}

}  // namespace

SafeSpace::SafeSpace(const PlanningMap& map, const VehicleLimits& limits, double margin_m, Unknown unknown)
    : map_(map),
      occupied_m_(std::min(limits.radius_m + margin_m, map.to_occupied().radius_m())),
      unknown_m_(unknown == Unknown::kFree ? 0 : std::min(limits.radius_m, map.to_unknown().radius_m())),
      occupied_vox2_(SquaredVoxels(occupied_m_ + map.to_occupied().caution_m(), map.grid().voxel_m())),
      unknown_vox2_(SquaredVoxels(unknown_m_, map.grid().voxel_m())),
      roomy_vox2_(SquaredVoxels(
          std::min(occupied_m_ + kRoomy_m, map.to_occupied().radius_m()) + map.to_occupied().caution_m(),
          map.grid().voxel_m())) {}

std::uint64_t SafeSpace::SafeVoxels(std::size_t first, int begin, int end) const {
  const std::uint16_t* occupied = map_.to_occupied().squared_vox() + first;
  const std::uint16_t* unknown = map_.to_unknown().squared_vox() + first;
  const __m256i occupied_least = _mm256_set1_epi16(static_cast<short>(occupied_vox2_));
  const __m256i unknown_least = _mm256_set1_epi16(static_cast<short>(unknown_vox2_));
  const auto safe16 = [&](int i) {
    const __m256i o = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(occupied + i));
    const __m256i u = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(unknown + i));
    return _mm256_and_si256(_mm256_cmpeq_epi16(_mm256_max_epu16(o, occupied_least), o),
                            _mm256_cmpeq_epi16(_mm256_max_epu16(u, unknown_least), u));
  };
  std::uint64_t bits = 0;
  if (end - begin < 32) {
    for (int i = begin; i < end; ++i)
      bits |= static_cast<std::uint64_t>(SafeVoxel(first + static_cast<std::size_t>(i))) << i;
    return bits;
  }
  for (int i = begin; i < end; i += 32) {
    i = std::min(i, end - 32);  // the last ones overlap
    const __m256i bytes = _mm256_permute4x64_epi64(_mm256_packs_epi16(safe16(i), safe16(i + 16)), 0xd8);
    bits |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes))) << i;
  }
  return bits;
}

double SafeSpace::Slack(const Eigen::Vector3d& p_W) const {
  const double outside = map_.grid().volume_W().exteriorDistance(p_W);
  if (outside > 0) return -outside;
  return std::min(map_.to_occupied().Interpolate(p_W) - occupied_m_,
                  map_.to_unknown().Interpolate(p_W) - unknown_m_);
}

bool SafeSpace::Safe(const Eigen::Vector3d& p_W) const {
  return (map_.grid().volume_W().contains(p_W) && map_.to_occupied().CertainlyBeyond(p_W, occupied_m_) &&
          map_.to_unknown().CertainlyBeyond(p_W, unknown_m_)) ||
         Slack(p_W) >= 0;
}

double SafeSpace::FreeRadius(const Eigen::Vector3d& p_W) const {
  return std::min(map_.to_occupied().Interpolate(p_W), map_.to_unknown().Interpolate(p_W));
}

bool SafeSpace::LegSafe(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W,
                        const std::vector<Ball>& avoid) const {
  const double length = (to_W - from_W).norm();
  for (double s = 0;;) {
    const Eigen::Vector3d p_W =
        length > 0 ? Eigen::Vector3d(from_W + (to_W - from_W) * (s / length)) : from_W;
    double slack = Slack(p_W);
    for (const Ball& ball : avoid) slack = std::min(slack, (p_W - ball.p_W).norm() - ball.radius_m);
    if (slack < -kTolerance_m) return false;
    if (s >= length) return true;
    s = std::min(length, s + std::max(kStepMin_m, slack));
  }
}

std::optional<VoxelIndex> SafeSpace::NearestSafeVoxel(const Eigen::Vector3d& p_W, double reach_m) const {
  const VoxelGrid& grid = map_.grid();
  const int reach = static_cast<int>(std::ceil(reach_m / grid.voxel_m()));
  const VoxelIndex centre = grid.IndexOf(p_W);
  if (SafeVoxel(centre)) return centre;
  const VoxelIndex lo = (centre.array() - reach).max(grid.inside_min().array());
  const VoxelIndex hi = (centre.array() + reach + 1).min(grid.inside_max().array());
  std::optional<VoxelIndex> nearest;
  double best = reach_m * reach_m;
  for (int z = lo.z(); z < hi.z(); ++z)
    for (int y = lo.y(); y < hi.y(); ++y)
      for (int x = lo.x(); x < hi.x(); ++x) {
        const VoxelIndex v(x, y, z);
        if (!SafeVoxel(grid.Linear(v))) continue;
        const double d2 = (grid.Centre(v) - p_W).squaredNorm();
        if (d2 < best) best = d2, nearest = v;
      }
  return nearest;
}

}  // namespace citrine::planner
