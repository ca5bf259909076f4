#pragma once

#include <functional>
#include <vector>

#include "core/map/mission_grid.h"
#include "modules/channels.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/map_summary.h"
#include "modules/runtime/bus.h"

namespace citrine::test {

/// Says a mission's whole map, as a base station does that knows every voxel and has seen all surfaces from
/// twice d*.
/// @param distance_m signed distance of a point to the nearest surface
inline void SayMap(const MissionConfig& config, Bus& bus,
                   const std::function<double(const Eigen::Vector3d&)>& distance_m) {
  PlanningMap map = MissionPlanningMap(config);
  const Quantisation& codes = map.quantisation();
  std::vector<MapBlock> blocks;
  for (int index = 0; index < map.grid().num_blocks(); ++index) {
    MapBlock block;
    block.index = index;
    block.version = 1;
    const VoxelIndex origin = map.grid().BlockOrigin(index);
    for (int z = 0; z < kBlockSide; ++z)
      for (int y = 0; y < kBlockSide; ++y)
        for (int x = 0; x < kBlockSide; ++x) {
          const VoxelIndex voxel = origin + VoxelIndex(x, y, z);
          const double d_m = distance_m(map.grid().Centre(voxel));
          block.distance[VoxelGrid::InBlock(voxel)] = codes.DistanceCode(d_m);
          if (std::abs(d_m) < config.map.voxel_m)
            block.weight[VoxelGrid::InBlock(voxel)] = codes.WeightCode(codes.weight_max() / 4);
        }
    map.Apply(block);
    blocks.push_back(block);
  }
  for (const citrine_lcm::map_blocks_t& message : EncodeInMessages(blocks))
    bus.Publish(channels::kMapBlocks, message);
  bus.Publish(channels::kMapSummary, Encode(MapSummary{map.grid(), codes.truncation_m(), codes.weight_max(),
                                                       1, map.num_blocks_known(), map.Digest()}));
}

}  // namespace citrine::test
