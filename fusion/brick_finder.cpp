#include "fusion/brick_finder.h"

namespace citrine::fusion {
namespace {

int LowestOf(int bits) { return __builtin_ctz(static_cast<unsigned>(bits)); }

}  // namespace

bool BrickFinder::NeverObserved(int block, int first_brick, int bricks) const {
  const TsdfBlock* known = known_[block];
  if (!known) return true;
  for (int left = bricks; left != 0; left &= left - 1)
    if ((Load(&known->weight[(first_brick + LowestOf(left)) * kBrickVoxels]) > 0.0f).any()) return false;
  return true;
}

void BrickFinder::Find(const ScanView& view) {
  octants_.clear();
  bricks_.clear();
  free_.clear();
  parts_.resize(blocks_.size());
  for (std::size_t i = 0; i < blocks_.size(); ++i) parts_[i] = view.CubesFrom(blocks_[i].lowest_S, 2);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const BrickSight& sight = parts_[i].sight;
    for (int left = sight.seen; left != 0; left &= left - 1) {
      const int number = LowestOf(left);
      const Cube octant{blocks_[i].block, 8 * number, parts_[i].Lowest(number)};
      const int clear = ClearOf(octant);
      if (clear == 0xff && (sight.passed >> number & 1)) continue;
      const int rest = ~clear & 0xff;
      if ((sight.free >> number & 1) && NeverObserved(octant.block, octant.first_brick, rest))
        free_.push_back({octant.block, octant.first_brick, rest});
      else
        octants_.push_back(octant);
    }
  }
  parts_.resize(octants_.size());
  for (std::size_t i = 0; i < octants_.size(); ++i) parts_[i] = view.CubesFrom(octants_[i].lowest_S, 1);
  for (std::size_t i = 0; i < octants_.size(); ++i) {
    const Cube& octant = octants_[i];
    const BrickSight& sight = parts_[i].sight;
    const int clear = ClearOf(octant);
    for (int left = sight.seen & ~(sight.passed & clear); left != 0; left &= left - 1) {
      const int number = LowestOf(left), brick = octant.first_brick + number;
      if ((sight.free >> number & 1) && NeverObserved(octant.block, brick, 1))
        free_.push_back({octant.block, brick, 1});
      else
        bricks_.push_back({octant.block, brick, parts_[i].Lowest(number)});
    }
  }
}

}  // namespace citrine::fusion
