#pragma once

#include <cstdint>
#include <string>

#include "modules/replay/recorded_mission.h"

namespace citrine {

struct McapSize {
  std::uint64_t messages = 0, bytes = 0;
};

/// Writes a recorded mission as an MCAP file for Foxglove, Rerun and PlotJuggler; the mission's text lies in
/// it as an attachment, its id and commit as metadata. The same recording gives the same bytes.
/// @throws std::runtime_error if the file cannot be written
McapSize ExportMcap(const RecordedMission& mission, const std::string& path);

}  // namespace citrine
