#pragma once

#include <vector>

#include "planner/view/elements.h"

namespace citrine::planner {

/// How many elements the group of each element has. Two elements are in one group if their cells of 2 m
/// touch, or a chain of such pairs joins them.
/// @param elements in any order
std::vector<int> GroupSizes(const std::vector<Element>& elements);

}  // namespace citrine::planner
