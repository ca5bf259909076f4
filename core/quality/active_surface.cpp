#include "core/quality/active_surface.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/grid/neighbours.h"
#include "core/quality/confidence.h"

namespace citrine {

namespace {

int LowestReachedCode(const Quantisation& quantisation, double w_star) {
  int code = 1;
  while (code < 255 && quantisation.Weight(static_cast<std::uint8_t>(code)) < kReached * w_star) ++code;
  return code;
}

}  // namespace

ActiveSurface::ActiveSurface(const VoxelGrid& grid, const Quantisation& quantisation, QualityGoals goals)
    : grid_(grid), goals_(std::move(goals)) {
  for (int code = 1; code < 256; ++code)
    in_band_[code] = std::abs(quantisation.Distance(static_cast<std::uint8_t>(code))) < grid.voxel_m();
  reached_code_whole_ = LowestReachedCode(quantisation, goals_.whole().w_star);
  for (const QualityGoals::Region& region : goals_.regions())
    reached_code_of_region_.push_back(LowestReachedCode(quantisation, region.goal.w_star));
  class_.resize(grid.num_voxels());
  version_.resize(grid.num_blocks());
  unknown_.resize(grid.num_blocks(), kBlockVoxels);
  discovered_.resize(grid.num_blocks());
}

bool ActiveSurface::Update(const PlanningMap& map) {
  bool changed = false;
  for (int block = 0; block < grid_.num_blocks(); ++block) {
    if (map.block_version(block) == version_[block]) continue;
    version_[block] = map.block_version(block);
    Recompute(map, block);
    changed = true;
  }
  if (changed) List();
  return changed;
}

void ActiveSurface::Recompute(const PlanningMap& map, int block) {
  const VoxelIndex origin = grid_.BlockOrigin(block);
  std::int32_t unknown = 0;
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y) {
      const std::uint8_t* row = &map.states()[grid_.Linear(origin + VoxelIndex(0, y, z))];
      unknown += static_cast<std::int32_t>(std::count(row, row + kBlockSide, std::uint8_t{0}));
    }
  if (unknown < unknown_[block]) discovered_[block] = last_discovery_ = map.revision();
  unknown_[block] = unknown;

  const VoxelIndex min = (origin.array() - 1).max(grid_.inside_min().array());
  const VoxelIndex max = (origin.array() + kBlockSide + 1).min(grid_.inside_max().array());
  VoxelIndex v;
  for (v.z() = min.z(); v.z() < max.z(); ++v.z())
    for (v.y() = min.y(); v.y() < max.y(); ++v.y())
      for (v.x() = min.x(); v.x() < max.x(); ++v.x()) {
        const std::size_t linear = grid_.Linear(v);
        const std::uint8_t now = Classify(map, v, linear);
        --counts_[class_[linear]];
        ++counts_[now];
        class_[linear] = now;
      }
}

std::uint8_t ActiveSurface::Classify(const PlanningMap& map, const VoxelIndex& v, std::size_t linear) const {
  SurfaceClass found = SurfaceClass::kNone;
  const VoxelState state = map.state(linear);
  if (state == VoxelState::kEmpty) {
    if (AnyNear(map, v, 1, VoxelState::kUnknown) && AnyNear(map, v, 2, VoxelState::kOccupied))
      found = SurfaceClass::kIse;
  } else if (in_band_[map.distance_code(linear)] && AnyNear(map, v, 1, VoxelState::kEmpty)) {
    found = map.weight_code(linear) >= ReachedCode(v) ? SurfaceClass::kReached : SurfaceClass::kLqse;
  }
  return static_cast<std::uint8_t>(found);
}

bool ActiveSurface::AnyNear(const PlanningMap& map, const VoxelIndex& v, int steps, VoxelState wanted) const {
  const auto any = [&](const auto& offsets) {
    for (const auto& o : offsets) {
      const VoxelIndex n = v + VoxelIndex(o[0], o[1], o[2]);
      if (grid_.Inside(n) && map.state(grid_.Linear(n)) == wanted) return true;
    }
    return false;
  };
  return steps == 1 ? any(kN6) : any(kN18);
}

int ActiveSurface::ReachedCode(const VoxelIndex& v) const {
  if (goals_.regions().empty()) return reached_code_whole_;
  const Eigen::Vector3d p_W = grid_.Centre(v);
  for (std::size_t i = 0; i < goals_.regions().size(); ++i)
    if (goals_.regions()[i].box_W.contains(p_W)) return reached_code_of_region_[i];
  return reached_code_whole_;
}

void ActiveSurface::List() {
  elements_.clear();
  const auto add = [&](std::size_t i) {
    if (class_[i] >= static_cast<std::uint8_t>(SurfaceClass::kLqse))
      elements_.push_back(static_cast<std::uint32_t>(i));
  };
  std::size_t i = 0;
  for (; i + 8 <= class_.size(); i += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, &class_[i], 8);
    if (eight == 0) continue;
    for (std::size_t k = i; k < i + 8; ++k) add(k);
  }
  for (; i < class_.size(); ++i) add(i);
}

}  // namespace citrine
