#include "modules/launch/module_list.h"

#include "modules/lidar_emulator/lidar_emulator_module.h"
#include "modules/map_fusion/map_fusion_module.h"
#include "modules/topdown_renderer/topdown_renderer_module.h"
#include "modules/trajectory_smoother/trajectory_smoother_module.h"
#include "modules/uav_dynamics/uav_dynamics_module.h"
#include "modules/view_planner/view_planner_module.h"

namespace citrine {

std::vector<ModuleKind> ModuleList() {
  return {KindOf<UavDynamicsModule>(), KindOf<LidarEmulatorModule>(),      KindOf<MapFusionModule>(),
          KindOf<ViewPlannerModule>(), KindOf<TrajectorySmootherModule>(), KindOf<TopdownRendererModule>()};
}

}  // namespace citrine
