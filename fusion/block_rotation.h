#pragma once

#include <vector>

namespace citrine::fusion {

/// Which blocks to say next: those that changed, then as many of the rest as let every block be said once a
/// round.
///
/// So a hearer that lost messages, or came late, has the sender's map after one round at the latest.
class BlockRotation {
 public:
  /// @param batches_a_round  calls of Next() in which every known block is said at least once
  BlockRotation(int num_blocks, int batches_a_round);

  /// @param changed  blocks to be said at once, ascending; from now on they are known and take part in the
  /// rotation
  /// @return `changed`, then the blocks whose turn it is; each once
  std::vector<int> Next(const std::vector<int>& changed);

 private:
  int batches_a_round_;
  int num_known_ = 0;
  int turn_ = 0;  ///< next block of the rotation
  std::vector<bool> known_;
};

}  // namespace citrine::fusion
