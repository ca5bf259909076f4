#include <cstdio>
#include <filesystem>

#include "modules/launch/commands.h"
#include "modules/mcap_export/export_mcap.h"
#include "modules/replay/recorded_mission.h"

namespace citrine {

int ExportLog(const std::string& folder_or_log, const std::string& to, const std::string& out) {
  const std::string log = FindLog(folder_or_log);
  const RecordedMission mission = ReadMission(log);
  const std::string path = out.empty() ? std::filesystem::path(log).replace_extension(to).string() : out;
  const McapSize size = ExportMcap(mission, path);
  std::printf("%s: %llu messages, %.1f MB; Foxglove, Rerun and PlotJuggler open it\n", path.c_str(),
              static_cast<unsigned long long>(size.messages), static_cast<double>(size.bytes) / 1e6);
  return kCompleted;
}

}  // namespace citrine
