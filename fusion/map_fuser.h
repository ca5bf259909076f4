#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/map/quantisation.h"
#include "core/map/tsdf_map.h"
#include "core/quality/quality_goal.h"
#include "fusion/tsdf_integrator.h"
#include "fusion/weight_policy.h"

namespace citrine::fusion {

/// Fuses the scans of all UAVs into one map, and knows what of it has changed since it was last said.
///
/// Scans of one instant are to come in order of UAV: the last bits depend on the order.
class MapFuser {
 public:
  /// @param goals  reaching one of them is said at once
  MapFuser(const VoxelGrid& grid, double truncation_m, const Quantisation& quantisation, WeightPolicy policy,
           const QualityGoals& goals = {});

  void Integrate(const LidarScan& scan);

  /// Goes on from a map of the same grid, before the first scan: all of it is yet to be said, in versions
  /// newer than those it was said in.
  void Restore(TsdfMap saved, std::int64_t integrations);

  std::int64_t integrations() const { return integrations_; }
  /// Full map.
  const TsdfMap& map() const { return map_; }
  /// Version of the map as it has been said: grows whenever a block's codes do.
  std::int64_t map_version() const { return version_said_; }

  /// How far distance and weight codes may have moved before a block is said anew out of turn: noise on
  /// averages would have all that is in view said all the time.
  static constexpr int kStillDistance = 2, kStillWeight = 5;

  /// Quantises what the scans have touched since the last call. A block gets its next version if a voxel's
  /// class or the goals that it reached differ from what was said of it last, or its codes have moved by more
  /// than the above.
  /// @return the indices of those, ascending
  std::vector<int> TakeChanged();

  /// Brings what is said of a known block up to date, for its turn in the rotation; its next version if codes
  /// differ.
  void Renew(int block);

  /// The map as it has been said, that is as of the last TakeChanged() and Renew(). @return nullptr for a
  /// block never observed
  const MapBlock* Said(int block) const { return said_[block].get(); }
  int num_blocks_said() const { return num_blocks_said_; }
  /// Summary of the map as it has been said.
  MapSummary Summary() const;

 private:
  bool Matters(const MapBlock& said, const MapBlock& now) const;
  void Say(const MapBlock& now);

  TsdfMap map_;
  Quantisation quantisation_;
  TsdfIntegrator integrator_;
  std::array<std::uint8_t, 256> class_of_{};  ///< by distance code
  std::array<std::uint8_t, 256> goals_of_{};  ///< by weight code: how many it reaches
  std::vector<std::uint8_t> touched_;         ///< one a block
  std::vector<std::unique_ptr<MapBlock>> said_;
  int num_blocks_said_ = 0;
  std::int64_t integrations_ = 0;  ///< those that changed something
  std::int64_t version_said_ = 0;  ///< integrations when a block last changed in what is said
};

}  // namespace citrine::fusion
