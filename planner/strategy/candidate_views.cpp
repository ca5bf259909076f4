#include "planner/strategy/candidate_views.h"

namespace citrine::planner {

namespace {

enum class Found { kView, kNothing, kUntested };

/// Beyond the paper's samples: the view that helped last time, the fan, the lattice; each as far as time
/// allows.
Found LookFurther(const PlanningMap& map, const Element& element, const ViewGenerator& generator,
                  SearchBudget& budget, ElementMemory& memory, std::optional<View>& view) {
  if (const View* last = memory.Fallback(element.linear); last && generator.Holds(*last, element)) {
    view = *last;
    return Found::kView;
  }
  if (budget.fans-- <= 0) return Found::kUntested;
  view = generator.Around(element);
  if (!view) {
    if (budget.lattices-- <= 0) return Found::kUntested;
    view = generator.Search(element, budget.answers);
  }
  if (!view) {
    memory.MarkUnreachable(element.linear, map.revision());
    return Found::kNothing;
  }
  memory.RememberFallback(*view);
  return Found::kView;
}

}  // namespace

Candidates MakeCandidates(const PlanningMap& map, const std::vector<Element>& elements,
                          const ViewGenerator& generator, bool per_cell, const Eigen::Vector3d& uav_W,
                          SearchBudget& budget, ElementMemory& memory) {
  Candidates candidates;
  SharedViews shared(map.grid());
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const int i = static_cast<int>(k);
    if (memory.Skips(elements[k].linear) || (per_cell && shared.Leader(elements, i) >= 0)) continue;
    std::optional<View> view = generator.AlongNormal(elements[k], uav_W);
    if (!view && LookFurther(map, elements[k], generator, budget, memory, view) == Found::kUntested)
      ++candidates.untested;
    if (!view) continue;
    candidates.views.push_back(*view);
    if (per_cell) shared.Lead(elements, i);
  }
  return candidates;
}

}  // namespace citrine::planner
