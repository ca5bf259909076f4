#include "fusion/tsdf_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/parallel_for.h"
#include "fusion/brick_finder.h"
#include "fusion/scan_view.h"

namespace citrine::fusion {
namespace {

// Blocks searched, and bricks looked at, one after the other before the first of them is gone on with.
constexpr int kBlocksTogether = 32;
constexpr std::size_t kTogether = 16;

}  // namespace

TsdfIntegrator::TsdfIntegrator(TsdfMap& map, WeightPolicy policy, int parts)
    : map_(map), policy_(policy), parts_(parts), fuser_(map.truncation_m(), policy) {}

std::vector<int> TsdfIntegrator::Integrate(const LidarScan& scan) {
  image_.Take(scan, map_.grid().voxel_m());
  bounds_.Take(image_, map_.truncation_m(), kBrickSide * map_.grid().voxel_m() / scan.model.range_max_m);
  const ScanView view(scan, map_, image_, bounds_);
  FindCandidates(view);
  const int count = static_cast<int>(candidates_.size());
  changed_.assign(candidates_.size(), 0);
  ParallelFor(count, parts_, [&](int begin, int end) {
    BrickFinder finder;
    for (int first = begin; first < end; first += kBlocksTogether)
      IntegrateBlocks(view, first, std::min(first + kBlocksTogether, end), finder);
  });
  std::vector<int> changed;
  for (int i = 0; i < count; ++i)
    if (changed_[i]) changed.push_back(candidates_[i]);
  if (policy_ == WeightPolicy::kPerPoint) CountPoints(scan, changed);
  return changed;
}

void TsdfIntegrator::FindCandidates(const ScanView& view) {
  const VoxelGrid& grid = map_.grid();
  const double block_m = kBlockSide * grid.voxel_m();
  const double reach_m = view.model().range_max_m + map_.truncation_m();
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(reach_m);
  const auto block_at = [&](const Eigen::Vector3d& p_W) -> Eigen::Vector3i {
    return ((p_W - grid.origin_W()) / block_m).array().floor().cast<int>();
  };
  const Eigen::Vector3i first = block_at(view.p_WS() - reach).cwiseMax(0);
  const Eigen::Vector3i last = block_at(view.p_WS() + reach).cwiseMin((grid.blocks().array() - 1).matrix());
  candidates_.clear();
  std::vector<Eigen::Vector3i> lowest;  // of eights of blocks
  for (int z = first.z(); z <= last.z(); z += 2)
    for (int y = first.y(); y <= last.y(); y += 2)
      for (int x = first.x(); x <= last.x(); x += 2) lowest.emplace_back(x, y, z);
  std::vector<EightCubes> eights(lowest.size());
  ParallelForEach(lowest.size(), parts_, [&](std::size_t i) {
    eights[i] = view.CubesFrom(view.InSensor(grid.Centre(kBlockSide * lowest[i])), 3);
  });
  for (std::size_t i = 0; i < lowest.size(); ++i)
    for (int seen = eights[i].sight.seen; seen != 0; seen &= seen - 1) {
      const int number = __builtin_ctz(static_cast<unsigned>(seen));
      const Eigen::Vector3i at = lowest[i] + Eigen::Vector3i(number & 1, number >> 1 & 1, number >> 2);
      if ((at.array() > last.array()).any()) continue;
      const int block = grid.Block(kBlockSide * at);
      const TsdfBlock* known = map_.Find(block);
      const bool clear = known && known->clear_bricks == ~std::uint64_t{0};
      if (!(clear && (eights[i].sight.passed >> number & 1))) candidates_.push_back(block);
    }
  std::sort(candidates_.begin(), candidates_.end());
}

void TsdfIntegrator::IntegrateBlocks(const ScanView& view, int begin, int end, BrickFinder& finder) {
  finder.Clear();
  for (int i = begin; i < end; ++i) {
    const TsdfBlock* known = map_.Find(candidates_[i]);
    finder.Add(view.InSensor(map_.grid().Centre(map_.grid().BlockOrigin(candidates_[i]))), known);
  }
  finder.Find(view);
  // A block is allocated only once something in it was observed.
  for (const BrickFinder::Free& free : finder.free()) {
    TsdfBlock& block = map_.Allocate(candidates_[begin + free.block]);
    for (int left = free.bricks; left != 0; left &= left - 1)
      fuser_.FuseFree(free.first_brick + __builtin_ctz(static_cast<unsigned>(left)), block);
    changed_[begin + free.block] = 1;
  }
  std::array<VoxelObserver::Look, kTogether> looks;
  const auto bricks = finder.bricks();
  for (std::size_t first = 0; first < bricks.size(); first += kTogether) {
    const std::size_t count = std::min(bricks.size() - first, kTogether);
    for (std::size_t i = 0; i < count; ++i) {
      if (const TsdfBlock* known = map_.Find(candidates_[begin + bricks[first + i].block])) {
        const int at = bricks[first + i].first_brick * kBrickVoxels;
        for (const float* field : {known->distance_m, known->weight, known->quality})
          _mm_prefetch(field + at, _MM_HINT_T0);
      }
      const Points voxels = view.VoxelsFrom(bricks[first + i].lowest_S);
      looks[i] = view.observer().LookAt(voxels.x, voxels.y, voxels.z);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const BrickFinder::Cube& brick = bricks[first + i];
      const int at = begin + brick.block;
      const Observation observation = view.observer().Observe(looks[i]);
      const TsdfBlock* known = map_.Find(candidates_[at]);
      const bool clear = known && (known->clear_bricks >> brick.first_brick & 1);
      const bool news = clear ? observation.in_band.any() : observation.said.any();
      if (news) changed_[at] |= fuser_.Fuse(observation, brick.first_brick, map_.Allocate(candidates_[at]));
    }
  }
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
