#include "modules/mcap_export/export_mcap.h"

#include <stdexcept>

#include "logs/mcap/mcap_writer.h"
#include "modules/mcap_export/mcap_exporter.h"
#include "modules/replay/replay.h"

namespace citrine {

McapSize ExportMcap(const RecordedMission& mission, const std::string& path) {
  logs::McapWriter writer(path);
  const MissionConfig& config = mission.config;
  writer.Describe("mission", {{"mission_id", mission.flown.mission_id},
                              {"commit", mission.flown.commit},
                              {"dirty", mission.flown.dirty ? "yes" : "no"},
                              {"strategy", config.planner.strategy},
                              {"uavs", std::to_string(config.mission.uavs)},
                              {"seed", std::to_string(config.mission.seed)}});
  writer.Attach("mission.toml", "application/toml", mission.flown.toml);
  ModuleKind exporter;
  exporter.name = McapExporter::kName;
  exporter.make = [&](const ModuleContext& context) {
    return std::make_unique<McapExporter>(context, writer);
  };
  exporter.make_map_hearer = [](const MissionConfig& flown, Bus& bus) {
    return std::make_shared<MapHearer>(flown, bus);
  };
  const Replayed replayed = Replay(mission.events, config, exporter, 0);
  if (!replayed.error.empty()) throw std::runtime_error(replayed.error);
  writer.Finish();
  return {writer.num_messages(), writer.num_bytes()};
}

}  // namespace citrine
