#include "fusion/block_rotation.h"

#include <algorithm>

namespace citrine::fusion {

BlockRotation::BlockRotation(int num_blocks, int batches_a_round)
    : batches_a_round_(std::max(batches_a_round, 1)), known_(num_blocks, false) {}

std::vector<int> BlockRotation::Next(const std::vector<int>& changed) {
  for (int block : changed) {
    num_known_ += !known_[block];
    known_[block] = true;
  }
  std::vector<int> next = changed;
  const int num_blocks = static_cast<int>(known_.size());
  int quota = (num_known_ + batches_a_round_ - 1) / batches_a_round_;
  for (int looked_at = 0; looked_at < num_blocks && quota > 0; ++looked_at) {
    const int block = turn_;
    turn_ = (turn_ + 1) % num_blocks;
    if (!known_[block]) continue;
    --quota;
    if (!std::binary_search(changed.begin(), changed.end(), block)) next.push_back(block);
  }
  return next;
}

}  // namespace citrine::fusion
