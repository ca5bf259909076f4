#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/map/quantisation.h"
#include "core/map/tsdf_map.h"
#include "fusion/tsdf_integrator.h"
#include "fusion/weight_policy.h"

namespace citrine::fusion {

/// Fuses the scans of all UAVs into one map, and knows what of it has changed since it was last said.
///
/// Scans of one instant are to come in order of UAV: the last bits depend on the order.
class MapFuser {
 public:
  MapFuser(const VoxelGrid& grid, double truncation_m, const Quantisation& quantisation, WeightPolicy policy);

  void Integrate(const LidarScan& scan);

  /// Goes on from a map of the same grid, before the first scan: all of it is yet to be said, in versions
  /// newer than those it was said in.
  void Restore(TsdfMap saved, std::int64_t integrations);

  std::int64_t integrations() const { return integrations_; }
  /// Full map.
  const TsdfMap& map() const { return map_; }
  /// Version of the map as it has been said: grows whenever a block's codes do.
  std::int64_t map_version() const { return version_said_; }

  /// Quantises what the scans have touched since the last call; a block whose codes differ from what was said
  /// of it last gets its next version. @return the indices of those, ascending
  std::vector<int> TakeChanged();

  /// The map as it has been said, that is as of the last TakeChanged(). @return nullptr for a block never
  /// observed
  const MapBlock* Said(int block) const { return said_[block].get(); }
  int num_blocks_said() const { return num_blocks_said_; }
  /// Summary of the map as it has been said.
  MapSummary Summary() const;

 private:
  TsdfMap map_;
  Quantisation quantisation_;
  TsdfIntegrator integrator_;
  std::vector<std::uint8_t> touched_;  ///< one a block
  std::vector<std::unique_ptr<MapBlock>> said_;
  int num_blocks_said_ = 0;
  std::int64_t integrations_ = 0;  ///< those that changed something
  std::int64_t version_said_ = 0;  ///< integrations when a block last changed in what is said
};

}  // namespace citrine::fusion
