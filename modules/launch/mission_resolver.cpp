#include "modules/launch/mission_resolver.h"

#include <filesystem>

#include "core/config/config_file.h"
#include "modules/codec/saved_map.h"
#include "modules/launch/mission_file.h"
#include "modules/launch/project.h"
#include "modules/runtime/module_id.h"
#include "sim/lidar/ray_scene.h"
#include "sim/world/spawn.h"
#include "sim/world/world.h"

namespace citrine {
namespace {

MissionConfig Parse(const MissionFile& file, const RunOptions& options) {
  try {
    return ParseMission(file.toml, options.overrides);
  } catch (const ConfigError& error) {
    throw ConfigError(file.path + ": " + error.what());
  }
}

/// Another world than the mission's own: starts that were chosen for that one mean nothing here.
void TakeWorld(const RunOptions& options, const MissionFile& file, MissionSection& mission) {
  if (!options.world.empty()) {
    mission.world = options.world;
    mission.spawns_m.clear();
  }
  if (mission.world.empty()) throw ConfigError(file.path + ": mission.world: missing, and no --world");
  mission.world = FindWorldFile(mission.world, file.path);
}

/// The map that the mission goes on from; one that does not fit is refused here, before anybody flies.
void TakeMap(const RunOptions& options, MissionConfig& config) {
  namespace fs = std::filesystem;
  if (!options.map.empty())
    config.map.start =
        fs::is_directory(options.map) ? (fs::path(options.map) / "map.tsdf").string() : options.map;
  if (config.map.start.empty()) return;
  config.map.start = fs::absolute(config.map.start).lexically_normal();
  ReadSavedMap(config.map.start, config);
}

void PlaceInWorld(const sim::World& world, MissionConfig& config) {
  MissionSection& mission = config.mission;
  if (!mission.volume_min_m) {
    const Eigen::AlignedBox3d volume_W = sim::DefaultVolume(world);
    mission.volume_min_m = volume_W.min();
    mission.volume_max_m = volume_W.max();
  }
  const sim::RayScene scene(world);
  mission.spawns_m = sim::PlaceSpawns(scene, config.volume_W(), mission.uavs, mission.spawns_m,
                                      config.uav.spawn_jitter_m, static_cast<std::uint64_t>(mission.seed));
  config.uav.spawn_jitter_m =
      0;  // the seed has moved them: flown again, the resolved mission begins in the same places
}

}  // namespace

ResolvedMission ResolveMission(const RunOptions& options) {
  const MissionFile file = ReadMissionFile(options.mission);
  ResolvedMission resolved;
  MissionConfig& config = resolved.config;
  config = Parse(file, options);
  TakeWorld(options, file, config.mission);
  if (config.launch.in_process) config.launch.pace = 0;
  if (config.launch.out.empty()) config.launch.out = "results/" + MissionId(config);
  config.launch.out = std::filesystem::absolute(config.launch.out).lexically_normal();
  resolved.world = std::make_shared<const sim::World>(sim::LoadWorld(config.mission.world));
  PlaceInWorld(*resolved.world, config);
  TakeMap(options, config);
  resolved.toml = ToToml(config);
  const SourceVersion version = ReadSourceVersion();
  resolved.flown = {MissionId(config), resolved.toml, options.overrides, version.commit, version.dirty};
  return resolved;
}

}  // namespace citrine
