#pragma once

#include <cstdint>
#include <string>

#include "core/config/mission_config.h"
#include "core/map/tsdf_map.h"

namespace citrine {

/// The base station's full map, to go on from: distances, weights and confidences of every block that was
/// seen.
struct SavedMap {
  TsdfMap map;
  std::int64_t integrations = 0;  ///< scans that changed it
};

/// Writes the map of a mission as a file, packed. @throws std::runtime_error if it cannot be written
void WriteSavedMap(const std::string& path, const TsdfMap& map, std::int64_t integrations,
                   const MissionConfig& config);

/// Reads it back, for a mission over the same grid with the same weights.
/// @throws ConfigError with the key map.start if it is no such file, is damaged, or is of another volume,
/// voxel, truncation or weight policy
SavedMap ReadSavedMap(const std::string& path, const MissionConfig& config);

}  // namespace citrine
