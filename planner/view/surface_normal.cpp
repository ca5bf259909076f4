#include "planner/view/surface_normal.h"

#include <algorithm>

#include "core/grid/neighbours.h"

namespace citrine::planner {

SurfaceNormal::SurfaceNormal(const PlanningMap& map, double w_star) : map_(map) {
  weight_[0] = w_star;
  for (int code = 1; code < 256; ++code)
    weight_[code] = std::min(map.quantisation().Weight(static_cast<std::uint8_t>(code)), w_star);
  for (std::size_t k = 0; k < kN26.size(); ++k) {
    const auto& o = kN26[k];
    direction_[k] = Eigen::Vector3d(o[0], o[1], o[2]).normalized();
    step_[k] = o[0] + o[1] * static_cast<std::ptrdiff_t>(map.grid().stride_y()) +
               o[2] * static_cast<std::ptrdiff_t>(map.grid().stride_z());
  }
}

Eigen::Vector3d SurfaceNormal::At(const VoxelIndex& v) const {
  const VoxelGrid& grid = map_.grid();
  const auto linear = static_cast<std::ptrdiff_t>(grid.Linear(v));
  const bool inner =
      ((v.array() > grid.inside_min().array()) && (v.array() + 1 < grid.inside_max().array())).all();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < kN26.size(); ++k) {
    const auto& o = kN26[k];
    if (!inner && !grid.Inside(v + VoxelIndex(o[0], o[1], o[2]))) continue;
    const auto n = static_cast<std::size_t>(linear + step_[k]);
    const VoxelState state = map_.state(n);
    if (state == VoxelState::kUnknown) continue;
    const double w = weight_[map_.weight_code(n)];
    sum += (state == VoxelState::kEmpty ? w : -w) * direction_[k];
  }
  const double norm = sum.norm();
  if (norm < 1e-6 * weight_[0]) return Eigen::Vector3d::Zero();
  return sum / norm;
}

}  // namespace citrine::planner
