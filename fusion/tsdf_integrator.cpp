#include "fusion/tsdf_integrator.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/parallel_for.h"
#include "fusion/brick_sight.h"

namespace citrine::fusion {
namespace {

// Share of its weight that a free observation has where a surface was seen before.
constexpr float kFreeOnSurface = 0.25f;

const Lanes kX = _mm256_setr_ps(0, 1, 0, 1, 0, 1, 0, 1), kY = _mm256_setr_ps(0, 0, 1, 1, 0, 0, 1, 1),
            kZ = _mm256_setr_ps(0, 0, 0, 0, 1, 1, 1, 1);

/// Eight points of the sensor frame [m].
struct Points {
  Lanes x, y, z;
};

}  // namespace

/// One scan, ready to be asked.
struct TsdfIntegrator::View {
  View(const LidarScan& scan, const TsdfMap& map, const RangeImage& range_image,
       const RangeBounds& range_bounds)
      : model(scan.model),
        observer(range_image, map.grid().voxel_m(), map.truncation_m()),
        bounds(range_bounds),
        voxel_m(static_cast<float>(map.grid().voxel_m())),
        truncation_m(static_cast<float>(map.truncation_m())),
        R_SW(scan.X_WS.q.conjugate().toRotationMatrix()),
        step((R_SW * map.grid().voxel_m()).cast<float>()),
        p_WS(scan.X_WS.p) {}

  /// Of the world in the sensor frame.
  Eigen::Vector3f InSensor(const Eigen::Vector3d& p_W) const { return (R_SW * (p_W - p_WS)).cast<float>(); }
  /// The corners of a cube at its lowest, `side` voxels apart: bit 0 of their number is x, bit 1 y, bit 2 z.
  Points EightFrom(const Eigen::Vector3f& lowest_S, float side) const {
    const auto along = [&](int axis) {
      return MulAdd(kX, side * step(axis, 0),
                    MulAdd(kY, side * step(axis, 1), MulAdd(kZ, side * step(axis, 2), lowest_S[axis])));
    };
    return {along(0), along(1), along(2)};
  }
  Eigen::Vector3f Corner(const Eigen::Vector3f& lowest_S, int number, float side) const {
    return lowest_S + step *
                          Eigen::Vector3f(static_cast<float>(number & 1), static_cast<float>(number >> 1 & 1),
                                          static_cast<float>(number >> 2)) *
                          side;
  }
  /// Of the eight cubes of `side` voxels that make one of twice that, from the centre of its lowest voxel on.
  BrickSight SightOfEight(const Eigen::Vector3f& lowest_S, int side) const {
    const float half = 0.5f * static_cast<float>(side - 1);
    const Eigen::Vector3f first_S = lowest_S + step * Eigen::Vector3f::Constant(half);
    return Sight(EightFrom(first_S, static_cast<float>(side)), half);
  }
  /// @param half  [voxels] from the centres of cubes to those of their outermost voxels, along an axis
  BrickSight Sight(const Points& centres, float half) const {
    const float radius_m = half * 1.7322f * voxel_m;  // a hair more than the root of 3
    return SightOf(centres.x, centres.y, centres.z, radius_m, model, observer, bounds, truncation_m);
  }

  const LidarModel& model;
  VoxelObserver observer;
  const RangeBounds& bounds;
  float voxel_m, truncation_m;
  Eigen::Matrix3d R_SW;
  Eigen::Matrix3f step;  ///< [m] of the sensor frame a voxel along each axis of the world
  Eigen::Vector3d p_WS;
};

TsdfIntegrator::TsdfIntegrator(TsdfMap& map, WeightPolicy policy, int threads)
    : map_(map), policy_(policy), threads_(threads) {}

std::vector<int> TsdfIntegrator::Integrate(const LidarScan& scan) {
  image_.Take(scan, map_.grid().voxel_m());
  bounds_.Take(image_, scan.model.range_max_m - 2 * map_.truncation_m());
  const View view(scan, map_, image_, bounds_);
  FindCandidates(view);
  const int count = static_cast<int>(candidates_.size());
  changed_.assign(candidates_.size(), 0);
  ParallelFor(count, threads_, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) changed_[i] = IntegrateBlock(view, candidates_[i]);
  });
  std::vector<int> changed;
  for (int i = 0; i < count; ++i)
    if (changed_[i]) changed.push_back(candidates_[i]);
  if (policy_ == WeightPolicy::kPerPoint) CountPoints(scan, changed);
  return changed;
}

void TsdfIntegrator::FindCandidates(const View& view) {
  const VoxelGrid& grid = map_.grid();
  const double block_m = kBlockSide * grid.voxel_m();
  const double reach_m = view.model.range_max_m + map_.truncation_m();
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(reach_m);
  const auto block_at = [&](const Eigen::Vector3d& p_W) -> Eigen::Vector3i {
    return ((p_W - grid.origin_W()) / block_m).array().floor().cast<int>();
  };
  const Eigen::Vector3i first = block_at(view.p_WS - reach).cwiseMax(0);
  const Eigen::Vector3i last = block_at(view.p_WS + reach).cwiseMin((grid.blocks().array() - 1).matrix());
  candidates_.clear();
  for (int z = first.z(); z <= last.z(); z += 2)
    for (int y = first.y(); y <= last.y(); y += 2)
      for (int x = first.x(); x <= last.x(); x += 2) {
        const VoxelIndex origin = kBlockSide * VoxelIndex(x, y, z);
        const BrickSight sight = view.SightOfEight(view.InSensor(grid.Centre(origin)), kBlockSide);
        for (int seen = Bits(sight.seen); seen != 0; seen &= seen - 1) {
          const int i = __builtin_ctz(static_cast<unsigned>(seen));
          const Eigen::Vector3i at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
          if ((at.array() > last.array()).any()) continue;
          const int block = grid.Block(kBlockSide * at);
          const TsdfBlock* known = map_.Find(block);
          const bool clear = known && known->clear_bricks == ~std::uint64_t{0};
          if (!(clear && (Bits(sight.passed) >> i & 1))) candidates_.push_back(block);
        }
      }
  std::sort(candidates_.begin(), candidates_.end());
}

bool TsdfIntegrator::IntegrateBlock(const View& view, int index) {
  const VoxelIndex origin = map_.grid().BlockOrigin(index);
  if (TsdfBlock* block = map_.Find(index)) return ObserveBricks(view, origin, *block);
  // A block is allocated only once something in it was observed.
  TsdfBlock fresh{};
  const bool changed = ObserveBricks(view, origin, fresh);
  if (changed) map_.Allocate(index) = fresh;
  return changed;
}

bool TsdfIntegrator::ObserveBricks(const View& view, const VoxelIndex& origin, TsdfBlock& block) const {
  bool changed = false;
  const Eigen::Vector3f block_S = view.InSensor(map_.grid().Centre(origin));
  const BrickSight octants = view.SightOfEight(block_S, 4);
  for (int left = Bits(octants.seen); left != 0; left &= left - 1) {
    const int octant = __builtin_ctz(static_cast<unsigned>(left));
    const int clear = static_cast<int>(block.clear_bricks >> (8 * octant) & 0xff);
    if (clear == 0xff && (Bits(octants.passed) >> octant & 1)) continue;
    if (Bits(octants.free) >> octant & 1) {
      changed |= Free(octants, octant, 8 * octant, ~clear & 0xff, block);
      continue;
    }
    const Eigen::Vector3f octant_S = view.Corner(block_S, octant, 4);
    const BrickSight bricks = view.SightOfEight(octant_S, 2);
    for (int some = Bits(bricks.seen) & ~(Bits(bricks.passed) & clear); some != 0; some &= some - 1) {
      const int brick = __builtin_ctz(static_cast<unsigned>(some));
      if (Bits(bricks.free) >> brick & 1) {
        changed |= Free(bricks, brick, 8 * octant, 1 << brick, block);
        continue;
      }
      const Points voxels = view.EightFrom(view.Corner(octant_S, brick, 2), 1);
      const Observation observation = view.observer.Observe(voxels.x, voxels.y, voxels.z);
      const bool news = (clear >> brick & 1) ? observation.in_band.any() : observation.said.any();
      if (news) changed |= Fuse(observation, 8 * octant + brick, block);
    }
  }
  return changed;
}

bool TsdfIntegrator::Free(const BrickSight& sight, int number, int first_brick, int bricks,
                          TsdfBlock& block) const {
  alignas(32) float farthest_m[8];
  Store(farthest_m, sight.farthest_m);
  const Lanes weight = 1 / (farthest_m[number] * farthest_m[number]);
  const auto truncation_m = static_cast<float>(map_.truncation_m());
  const Observation free{Mask::Everywhere(), Mask::Nowhere(), truncation_m, weight, 1.0f};
  bool changed = false;
  for (; bricks != 0; bricks &= bricks - 1) {
    const int brick = first_brick + __builtin_ctz(static_cast<unsigned>(bricks)), at = brick * kBrickVoxels;
    if ((Load(&block.weight[at]) > 0.0f).any()) {
      changed |= Fuse(free, brick, block);
      continue;
    }
    Store(&block.distance_m[at], truncation_m);
    Store(&block.weight[at], weight);
    block.clear_bricks |= std::uint64_t{1} << brick;
    changed = true;
  }
  return changed;
}

bool TsdfIntegrator::Fuse(const Observation& observation, int brick, TsdfBlock& block) const {
  const int at = brick * kBrickVoxels;
  const Lanes distance = Load(&block.distance_m[at]), weight = Load(&block.weight[at]),
              quality = Load(&block.quality[at]);
  const auto truncation_m = static_cast<float>(map_.truncation_m());
  const Lanes codes_per_m = 127.0f / truncation_m;

  // A free ray seldom knows better than whoever saw a surface here from nearer by, and nothing new where all
  // is free.
  const Mask is_free = observation.sdf_m >= truncation_m, was_known = weight > 0.0f;
  const Mask nothing_new = is_free & was_known & (distance >= truncation_m);
  const Mask free_on_surface = Without((quality > 0.0f) & is_free, observation.in_band);
  const Lanes ratio = Min(observation.weight / Max(quality, 1e-9f), 1.0f);
  const Lanes share = Select(free_on_surface, ratio * ratio * kFreeOnSurface, 1.0f) * observation.share;
  const Mask said = Without(observation.said, nothing_new);
  const Lanes added = Select(said, observation.weight * share, 0.0f);
  const Lanes sum = weight + added;
  const Lanes mean = MulAdd(distance, weight, observation.sdf_m * added) / Max(sum, 1e-30f);
  const Lanes fused = Select(said, Min(Max(mean, -truncation_m), truncation_m), distance);

  Lanes confidence = quality;
  if (policy_ == WeightPolicy::kBestView)
    confidence = Select(observation.in_band, Max(quality, observation.weight), quality);
  else if (policy_ == WeightPolicy::kPerScan)
    confidence = Select(observation.in_band, quality + observation.weight, quality);
  Store(&block.distance_m[at], fused);
  Store(&block.weight[at], sum);
  Store(&block.quality[at], confidence);
  const Mask clear = Without((fused >= truncation_m) & (sum > 0.0f), confidence > 0.0f);
  const std::uint64_t bit = std::uint64_t{1} << brick;
  block.clear_bricks = clear.all() ? block.clear_bricks | bit : block.clear_bricks & ~bit;

  const Mask first_seen = Without(sum > 0.0f, was_known);
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
      const int at = TsdfBlock::IndexOf(voxel);
      if (!block || !(block->weight[at] > 0)) continue;
      block->quality[at] += 1 / (range_m * range_m);
      changed.push_back(index);
    }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
}

}  // namespace citrine::fusion
