#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/grid/voxel_grid.h"

namespace citrine {

/// One block of the map as it travels: quantised, whole, versioned (see core/map/quantisation.h for the
/// codes).
struct MapBlock {
  std::int32_t index = 0;                             ///< VoxelGrid::Block
  std::array<std::uint8_t, kBlockVoxels> distance{};  ///< distance codes, VoxelGrid::InBlock order
  std::array<std::uint8_t, kBlockVoxels> weight{};    ///< weight codes, surface band only, 0 elsewhere
  std::uint32_t version = 0;                          ///< counts up with every change; 0: never observed

  /// Index, distance and weight codes, as one run of bytes: what MapSummary::digest is over.
  std::span<const std::byte> content() const {
    static_assert(offsetof(MapBlock, version) == sizeof index + sizeof distance + sizeof weight);
    return std::as_bytes(std::span(this, 1)).first<sizeof index + sizeof distance + sizeof weight>();
  }
};

/// What identifies a map: how a hearer knows that it missed something.
struct MapSummary {
  VoxelGrid grid;
  double truncation_m = 0;
  double weight_max = 0;         ///< largest w* of the mission: the top of the weight code
  std::int64_t map_version = 0;  ///< counts integrations that changed a block
  std::int32_t num_blocks = 0;   ///< blocks with version > 0
  std::uint64_t digest = 0;  ///< XXH64 over index, distance and weight codes of those blocks, in index order
};

}  // namespace citrine
