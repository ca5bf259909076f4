#pragma once

#include <vector>

#include "core/config/mission_config.h"
#include "core/map/tri_mesh.h"
#include "modules/runtime/log_event.h"

namespace citrine {

/// The mesh that the recorded scans amount to: fused again in the order in which they were said, returns on
/// teammates left out.
TriMesh RebuildMesh(const std::vector<LogEvent>& events, const MissionConfig& config);

}  // namespace citrine
