#pragma once

#include <vector>

#include "planner/strategy/element_memory.h"
#include "planner/view/view_generator.h"

namespace citrine::planner {

/// The candidates of one decision.
struct Candidates {
  std::vector<View> views;  ///< ascending by element
  int untested = 0;         ///< elements without a view so far that were not tested for lack of time
};

/// How much a decision may still search beyond the paper's samples, and what it has found out on the way.
struct SearchBudget {
  int fans = 300;
  int lattices = 40;
  ViewGenerator::LatticeAnswers answers = {};
};

/// A view for every element, or for every group of like elements (design, section 6). Elements for which
/// neither the normal nor the fan nor the whole lattice yields a view are remembered as unreachable; what the
/// memory skips is left out. @param budget  what is searched is taken off it
Candidates MakeCandidates(const PlanningMap& map, const std::vector<Element>& elements,
                          const ViewGenerator& generator, bool per_cell, const Eigen::Vector3d& uav_W,
                          SearchBudget& budget, ElementMemory& memory);

}  // namespace citrine::planner
