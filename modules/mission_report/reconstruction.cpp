#include "modules/mission_report/reconstruction.h"

#include <map>
#include <utility>

#include "core/map/mission_grid.h"
#include "fusion/map_fuser.h"
#include "fusion/surface_mesh.h"
#include "fusion/teammate_filter.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/saved_map.h"
#include "modules/codec/uav_state.h"
#include "modules/mission_report/recorded_message.h"

namespace citrine {

TriMesh RebuildMesh(const std::vector<LogEvent>& events, const MissionConfig& config) {
  const auto policy = fusion::WeightPolicyOf(config.map.weight_policy);
  fusion::MapFuser fuser(MissionGrid(config), config.map.truncation_m, MissionQuantisation(config),
                         policy.value());
  if (!config.map.start.empty()) {
    SavedMap saved = ReadSavedMap(config.map.start, config);
    fuser.Restore(std::move(saved.map), saved.integrations);
  }
  std::map<int, Eigen::Vector3d> position_W_by_uav;
  for (const LogEvent& event : events) {
    const RecordedMessage said(event);
    try {
      said.On(channels::kUavState, [&](const auto& m) { position_W_by_uav[said.uav] = Decode(m).X_WB.p; });
      said.On(channels::kLidarScan, [&](const auto& m) {
        LidarScan scan = Decode(m);
        std::vector<Eigen::Vector3d> teammates_W;
        for (const auto& [uav, p_W] : position_W_by_uav)
          if (uav != said.uav) teammates_W.push_back(p_W);
        fusion::DropTeammates(scan, teammates_W);
        fuser.Integrate(scan);
      });
    } catch (const BadMessage&) {
      continue;  // the base station left it out as well
    }
  }
  return fusion::SurfaceMesh(fuser.map());
}

}  // namespace citrine
