#include "planner/view/groups.h"

#include <array>
#include <map>

namespace citrine::planner {

namespace {

constexpr double kCell_m = 2.0;
using Cell = std::array<int, 3>;

Cell CellOf(const Element& element) {
  const Eigen::Vector3i c = (element.p_W / kCell_m).array().floor().cast<int>();
  return {c.x(), c.y(), c.z()};
}

}  // namespace

std::vector<int> GroupSizes(const std::vector<Element>& elements) {
  struct Occupant {
    int elements = 0, group = -1;
  };
  std::map<Cell, Occupant> cells;
  for (const Element& element : elements) ++cells[CellOf(element)].elements;

  std::vector<int> sizes;
  std::vector<std::map<Cell, Occupant>::iterator> queue;
  for (auto seed = cells.begin(); seed != cells.end(); ++seed) {
    if (seed->second.group >= 0) continue;
    const int group = static_cast<int>(sizes.size());
    sizes.push_back(0);
    seed->second.group = group;
    queue.push_back(seed);
    while (!queue.empty()) {
      const auto [cell, occupant] = *queue.back();
      queue.pop_back();
      sizes[group] += occupant.elements;
      for (int neighbour = 0; neighbour < 27; ++neighbour) {
        const auto it = cells.find(
            {cell[0] + neighbour % 3 - 1, cell[1] + neighbour / 3 % 3 - 1, cell[2] + neighbour / 9 - 1});
        if (it == cells.end() || it->second.group >= 0) continue;
        it->second.group = group;
        queue.push_back(it);
      }
    }
  }
  std::vector<int> of_element;
  for (const Element& element : elements) of_element.push_back(sizes[cells.at(CellOf(element)).group]);
  return of_element;
}

}  // namespace citrine::planner
