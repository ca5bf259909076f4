#pragma once

#include <array>

#include "core/grid/neighbours.h"

namespace citrine::planner {

namespace detail {
/// Ten times the length of a step with 1, 2 or 3 axes.
inline constexpr std::array<std::uint32_t, 4> kStepLength = {0, 10, 14, 17};
}  // namespace detail

template <class Cost>
std::vector<VoxelIndex> LatticeSearch::Find(const VoxelIndex& from, const VoxelIndex& to, int tolerance_vox,
                                            int closed_max, Cost&& cost) {
  Begin(from);
  const VoxelIndex lo = grid_.inside_min(), hi = grid_.inside_max();
  for (int closed = 0; !open_.empty() && closed < closed_max;) {
    const Open here = Pop();
    if (nodes_[here.node].closed) continue;
    nodes_[here.node].closed = true;
    ++closed;
    const VoxelIndex v = VoxelOf(here.node);
    const std::uint32_t lacks = Heuristic(v, to);
    if (lacks < nearest_estimate_) nearest_estimate_ = lacks, nearest_ = here.node;
    if ((v - to).cwiseAbs().maxCoeff() <= tolerance_vox) return Trace(here.node);
    for (std::size_t n = 0; n < kN26.size(); ++n) {
      const VoxelIndex step(kN26[n][0], kN26[n][1], kN26[n][2]);
      const VoxelIndex next = v + stride_ * step;
      if ((next.array() < lo.array()).any() || (next.array() >= hi.array()).any()) continue;
      const std::uint32_t node = NodeOf(next);
      Node& record = nodes_[node];
      if (record.round == round_ && record.closed) continue;
      const std::uint32_t price = cost(next, grid_.Linear(next));
      if (price == 0) continue;
      if (stride_ == 2 && cost(v + step, grid_.Linear(v + step)) == 0) continue;
      const std::uint32_t travelled = here.travelled + price * detail::kStepLength[step.cwiseAbs().sum()];
      if (record.round == round_ && record.travelled <= travelled) continue;
      record = {round_, travelled, static_cast<std::int8_t>(n), false};
      Push({travelled + Heuristic(next, to), travelled, node});
    }
  }
  return {};
}

}  // namespace citrine::planner
