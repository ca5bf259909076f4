#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "planner/view/elements.h"

namespace citrine::planner {

/// Elements that are worked on together: those of one cell of 5 m.
struct Patch {
  Eigen::Vector3d centre_W = Eigen::Vector3d::Zero();  ///< [m] of its elements
  std::vector<std::size_t> elements;                   ///< indices, ascending
};

/// The patches of elements, in order of their cells.
std::vector<Patch> PatchesOf(const std::vector<Element>& elements);

}  // namespace citrine::planner
