#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/map/planning_map.h"
#include "core/random.h"

namespace citrine::testing {

/// A planning map of boxes in known and unknown space: distances by brute force to the boxes, weights at
/// random.
class RandomMap {
 public:
  explicit RandomMap(std::uint64_t seed, const Eigen::Vector3d& size_m = {12, 10, 8}, int boxes = 6)
      : random_(seed),
        grid_(0.25, Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), size_m), 0.75),
        quantisation_(0.5, 1 / (4.5 * 4.5)),
        map(grid_, quantisation_) {
    for (int i = 0; i < boxes; ++i) {
      const Eigen::Vector3d corner = Point(size_m),
                            extent = Point({2, 2, 3}) + Eigen::Vector3d::Constant(0.3);
      boxes_.emplace_back(corner, corner + extent);
    }
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d corner = Point({0.6 * size_m.x(), 0.6 * size_m.y(), 1});
      hidden_.emplace_back(corner, corner + Point({2, 2, 2}) + Eigen::Vector3d::Constant(2));
    }
    for (int block = 0; block < grid_.num_blocks(); ++block) Say(block);
    map.Update();
  }

  /// Says a block again, as it would be with other weights and without some of the hidden space.
  void Say(int index) {
    MapBlock block;
    block.index = index;
    block.version = map.block_version(index) + 1;
    const VoxelIndex origin = grid_.BlockOrigin(index);
    for (int z = 0; z < kBlockSide; ++z)
      for (int y = 0; y < kBlockSide; ++y)
        for (int x = 0; x < kBlockSide; ++x) {
          const VoxelIndex v = origin + VoxelIndex(x, y, z);
          const Eigen::Vector3d p_W = grid_.Centre(v);
          double distance_m = p_W.z();
          for (const auto& box : boxes_)
            distance_m = std::min(distance_m, box.contains(p_W) ? -0.3 : box.exteriorDistance(p_W));
          bool unknown = distance_m < -0.45;
          for (const auto& hidden : hidden_) unknown |= hidden.contains(p_W);
          if (unknown) continue;
          block.distance[VoxelGrid::InBlock(v)] = quantisation_.DistanceCode(distance_m);
          if (std::abs(distance_m) < 0.25)
            block.weight[VoxelGrid::InBlock(v)] = quantisation_.WeightCode(random_.Uniform(0.01, 0.06));
        }
    map.Apply(block);
  }
  void Reveal() {
    if (!hidden_.empty()) hidden_.pop_back();
  }

  Eigen::Vector3d Point(const Eigen::Vector3d& size_m) {
    const double x = random_.Uniform(0, size_m.x()), y = random_.Uniform(0, size_m.y());
    return {x, y, random_.Uniform(0, size_m.z())};
  }
  Random& random() { return random_; }

 private:
  Random random_;
  VoxelGrid grid_;
  Quantisation quantisation_;
  std::vector<Eigen::AlignedBox3d> boxes_, hidden_;

 public:
  PlanningMap map;
};

}  // namespace citrine::testing
