#include "planner/strategy/strays.h"

#include <algorithm>
#include <cmath>

namespace citrine::planner {

namespace {

constexpr double kCell_m = 1.0;

/// How many elements lie in each cell of a metre; a border of one cell is empty.
class Crowd {
 public:
  Crowd(const std::vector<Element>& elements, const VoxelGrid& grid)
      : side_(std::max(1, static_cast<int>(std::lround(kCell_m / grid.voxel_m())))),
        cells_(grid.voxels().array() / side_ + 3),
        count_(static_cast<std::size_t>(cells_.prod()), 0) {
    for (const Element& element : elements) ++count_[CellOf(element)];
  }

  /// Whether more than `most` elements lie in an element's cell and those around.
  bool IsLargerAt(const Element& element, int most) const {
    const std::size_t cell = CellOf(element);
    if (count_[cell] > most) return true;
    int company = 0;
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y) {
        const std::size_t row = cell + static_cast<std::size_t>(cells_.x() * (y + cells_.y() * z));
        company += count_[row - 1] + count_[row] + count_[row + 1];
      }
    return company > most;
  }

 private:
  std::size_t CellOf(const Element& element) const {
    const Eigen::Vector3i c = element.voxel.array() / side_ + 1;
    return static_cast<std::size_t>(c.x() + cells_.x() * (c.y() + cells_.y() * c.z()));
  }

  int side_;  ///< voxels
  Eigen::Vector3i cells_;
  std::vector<int> count_;
};

}  // namespace

void LeaveStrays(std::vector<Element>& elements, const VoxelGrid& grid, double row_m) {
  const int most = static_cast<int>(std::lround(row_m / grid.voxel_m()));
  if (most == 0) return;
  const Crowd crowd(elements, grid);
  std::erase_if(elements, [&](const Element& element) {
    return element.kind == SurfaceClass::kLqse && !crowd.IsLargerAt(element, most);
  });
}

}  // namespace citrine::planner
