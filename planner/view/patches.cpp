#include "planner/view/patches.h"

#include <array>
#include <map>

namespace citrine::planner {

namespace {
constexpr double kPatch_m = 5.0;
}  // namespace

std::vector<Patch> PatchesOf(const std::vector<Element>& elements) {
  std::map<std::array<int, 3>, Patch> by_cell;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Eigen::Vector3i c = (elements[i].p_W / kPatch_m).array().floor().cast<int>();
    Patch& patch = by_cell[{c.x(), c.y(), c.z()}];
    patch.centre_W += elements[i].p_W;
    patch.elements.push_back(i);
  }
  std::vector<Patch> patches;
  for (auto& [cell, patch] : by_cell) {
    patch.centre_W /= static_cast<double>(patch.elements.size());
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace citrine::planner
