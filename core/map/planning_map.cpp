#include "core/map/planning_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "core/digest.h"
#include "core/map/dirty_boxes.h"
#include "core/parallel_for.h"

namespace citrine {
namespace {

int Voxels(double metres, const VoxelGrid& grid) {
  return std::clamp(static_cast<int>(std::ceil(metres / grid.voxel_m() - 1e-9)), 1, 181);
}

}  // namespace

PlanningMap::PlanningMap(const VoxelGrid& grid, const Quantisation& quantisation)
    : grid_(grid),
      quantisation_(quantisation),
      distance_(grid.num_voxels(), kUnknownCode),
      weight_(grid.num_voxels(), 0),
      state_(grid.num_voxels(), static_cast<std::uint8_t>(VoxelState::kUnknown)),
      occupied_site_(grid.num_voxels(), 0),
      unknown_site_(grid.num_voxels(), 0),
      version_(grid.num_blocks(), 0),
      never_unknown_(grid.num_voxels(), 1),
      to_occupied_(grid, Voxels(kOccupiedReach_m, grid), kCaution_vox * grid.voxel_m()),
      to_unknown_(grid, Voxels(kUnknownReach_m, grid)) {
  for (int code = 1; code < 256; ++code) {
    const double distance_m = quantisation.Distance(static_cast<std::uint8_t>(code));
    const VoxelState state = distance_m > grid.voxel_m() ? VoxelState::kEmpty : VoxelState::kOccupied;
    state_of_[code] = static_cast<std::uint8_t>(state);
    occupied_of_[code] = distance_m < kSiteBelow_vox * grid.voxel_m();
  }
  const VoxelIndex &min = grid.inside_min(), &max = grid.inside_max();
  for (int z = min.z(); z < max.z(); ++z)
    for (int y = min.y(); y < max.y(); ++y) {
      const std::size_t row = grid.Linear({min.x(), y, z});
      std::fill_n(&never_unknown_[row], max.x() - min.x(), std::uint8_t{0});
      std::fill_n(&unknown_site_[row], max.x() - min.x(), std::uint8_t{1});
    }
  to_unknown_.Update(unknown_site_, VoxelIndex::Zero(), grid.voxels());
}

void PlanningMap::AssumeFree(const Ball& ball) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ball.radius_m);
  const VoxelIndex min = grid_.IndexOf(ball.p_W - reach).cwiseMax(0);
  const VoxelIndex max = (grid_.IndexOf(ball.p_W + reach).array() + 1).min(grid_.voxels().array());
  for (int z = min.z(); z < max.z(); ++z)
    for (int y = min.y(); y < max.y(); ++y)
      for (int x = min.x(); x < max.x(); ++x) {
        if ((grid_.Centre({x, y, z}) - ball.p_W).norm() > ball.radius_m) continue;
        const std::size_t i = grid_.Linear({x, y, z});
        never_unknown_[i] = 1;
        unknown_site_[i] = 0;
      }
  to_unknown_.Update(unknown_site_, min, max);
}

PlanningMap::SiteChange PlanningMap::WriteRow(std::size_t linear, const std::uint8_t* distance,
                                              const std::uint8_t* weight) {
  SiteChange change;
  const bool same_distance = std::memcmp(&distance_[linear], distance, kBlockSide) == 0;
  change.any = !same_distance || std::memcmp(&weight_[linear], weight, kBlockSide) != 0;
  std::memcpy(&weight_[linear], weight, kBlockSide);
  if (same_distance) return change;
  std::memcpy(&distance_[linear], distance, kBlockSide);
  for (int i = 0; i < kBlockSide; ++i) {
    const std::size_t at = linear + i;
    const std::uint8_t code = distance[i];
    const std::uint8_t unknown = code == kUnknownCode && !never_unknown_[at];
    change.occupied |= occupied_site_[at] != occupied_of_[code];
    change.unknown |= unknown_site_[at] != unknown;
    state_[at] = state_of_[code];
    occupied_site_[at] = occupied_of_[code];
    unknown_site_[at] = unknown;
  }
  return change;
}

bool PlanningMap::Apply(const MapBlock& block) {
  if (block.index < 0 || block.index >= grid_.num_blocks())
    throw std::out_of_range("no such block of the map");
  if (block.version <= version_[block.index]) return false;
  SiteChange change;
  change.any = version_[block.index] == 0;
  num_blocks_known_ += version_[block.index] == 0;
  version_[block.index] = block.version;
  const VoxelIndex origin = grid_.BlockOrigin(block.index);
  for (int row = 0; row < kBlockSide * kBlockSide; ++row) {
    const VoxelIndex first = origin + VoxelIndex(0, row % kBlockSide, row / kBlockSide);
    const SiteChange in_row =
        WriteRow(grid_.Linear(first), &block.distance[row * kBlockSide], &block.weight[row * kBlockSide]);
    change.any |= in_row.any;
    change.occupied |= in_row.occupied;
    change.unknown |= in_row.unknown;
  }
  if (change.any) pending_.push_back(block.index);
  if (change.occupied) pending_occupied_.push_back(block.index);
  if (change.unknown) pending_unknown_.push_back(block.index);
  return change.any;
}

bool PlanningMap::Update(const std::vector<std::function<void()>>& meanwhile) {
  if (pending_.empty()) return false;
  std::sort(pending_.begin(), pending_.end());
  pending_.erase(std::unique(pending_.begin(), pending_.end()), pending_.end());
  changed_ = std::exchange(pending_, {});
  ++revision_;
  const auto update = [this](DistanceField& field, std::vector<int>& pending,
                             const std::vector<std::uint8_t>& sites) {
    for (const DirtyBox& box : DirtyBoxes(grid_, std::exchange(pending, {}), field.radius_vox()))
      field.Update(sites, box.min, box.max);
  };
  RunParts(2 + static_cast<int>(meanwhile.size()), [&](int part) {
    if (part == 0)
      update(to_occupied_, pending_occupied_, occupied_site_);
    else if (part == 1)
      update(to_unknown_, pending_unknown_, unknown_site_);
    else
      meanwhile[static_cast<std::size_t>(part) - 2]();
  });
  return true;
}

std::uint64_t PlanningMap::Digest() const {
  citrine::Digest digest;
  MapBlock block;
  for (block.index = 0; block.index < grid_.num_blocks(); ++block.index) {
    if (version_[block.index] == 0) continue;
    const std::size_t origin = grid_.Linear(grid_.BlockOrigin(block.index));
    for (std::size_t row = 0; row < kBlockSide * kBlockSide; ++row) {
      const std::size_t first =
          origin + row % kBlockSide * grid_.stride_y() + row / kBlockSide * grid_.stride_z();
      std::memcpy(&block.distance[row * kBlockSide], &distance_[first], kBlockSide);
      std::memcpy(&block.weight[row * kBlockSide], &weight_[first], kBlockSide);
    }
    digest.Add(block.content().data(), block.content().size());
  }
  return digest.value();
}

}  // namespace citrine
