#include "modules/topdown_renderer/scene_hearer.h"

#include <algorithm>
#include <utility>

#include "modules/channels.h"
#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/path.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/map_hearer.h"

namespace citrine {

namespace {
constexpr double kTrailSpacing_m = 0.1;
}

SceneHearer::SceneHearer(const ModuleContext& context)
    : bus_(context.bus), uavs_(context.config.mission.uavs), map_hearer_(context.map_hearer), inboxes_(bus_) {
  const MissionConfig& config = context.config;
  scene_.mission = config.mission.name;
  scene_.strategy = config.planner.strategy + ", seed " + std::to_string(config.mission.seed);
  scene_.map = &map_hearer_->map();
  scene_.goals = config.quality_goals();
  scene_.uav_radius_m = config.uav.limits.radius_m;
  scene_.ceiling_m = config.viz.ceiling_m;
  scene_.uavs.resize(static_cast<std::size_t>(config.mission.uavs));
  for (std::size_t i = 0; i < scene_.uavs.size(); ++i) {
    scene_.uavs[i].id = static_cast<int>(i) + 1;
    if (i < config.mission.spawns_m.size()) scene_.uavs[i].state.X_WB.p = config.mission.spawns_m[i];
  }
}

void SceneHearer::Update(const Step& step) {
  scene_.now = step.now;
  map_hearer_->Update(step);
  HearStates();
  HearPlans();
  HearAssignments();
  ForgetWhatIsOver(step.last);
  HearProgress();
}

void SceneHearer::HearStates() {
  HearNouns(bus_, channels::kUavState, uavs_, *inboxes_.states, [this](int id, const UavState& state, Utime) {
    viz::SceneUav& uav = UavOf(id);
    uav.state = state;
    const Eigen::Vector3d& p_W = state.X_WB.p;
    const double moved_m = uav.trail_W.empty() ? 0 : (p_W - uav.trail_W.back()).norm();
    if (!uav.trail_W.empty() && moved_m < kTrailSpacing_m) return;
    uav.trail_W.push_back(p_W);
    uav.flown_m += moved_m;
  });
}

void SceneHearer::HearPlans() {
  HearNouns(bus_, channels::kPath, uavs_, *inboxes_.paths,
            [this](int id, Path&& path, Utime) { UavOf(id).path = std::move(path); });
  HearNouns(bus_, channels::kTrajectory, uavs_, *inboxes_.trajectories,
            [this](int id, Trajectory&& trajectory, Utime) {
              std::optional<Trajectory>& newest = UavOf(id).trajectory;
              if (!newest || Supersedes(trajectory, *newest)) newest = std::move(trajectory);
            });
  HearNouns(bus_, channels::kFleetStatus, uavs_, *inboxes_.statuses,
            [this](int id, const FleetStatus& status, Utime) { UavOf(id).status = status; });
}

void SceneHearer::HearAssignments() {
  HearNouns(bus_, channels::kFleetAssignment, *inboxes_.assignments,
            [this](const FleetAssignment& heard, Utime) {
              if (heard.plan_id < newest_plan_) return;
              newest_plan_ = heard.plan_id;
              assignment_expiry_ = heard.expiry;
              for (std::size_t i = 0; i < std::min(scene_.uavs.size(), heard.centroid_W_by_uav.size()); ++i)
                scene_.uavs[i].centroid_W = heard.centroid_W_by_uav[i];
            });
}

/// A correction of the balance is over for a UAV that has made its selections or knows a newer one, for all
/// when its time has run out, and with the mission.
void SceneHearer::ForgetWhatIsOver(bool mission_is_over) {
  const bool for_all = mission_is_over || scene_.now > assignment_expiry_;
  for (viz::SceneUav& uav : scene_.uavs) {
    const bool done =
        uav.status && (uav.status->plan_id > newest_plan_ ||
                       (uav.status->plan_id == newest_plan_ && uav.status->corrected_selections_left == 0));
    if (for_all || done) uav.centroid_W.reset();
  }
}

void SceneHearer::HearProgress() {
  HearNouns(bus_, channels::kMissionProgress, *inboxes_.progress,
            [this](const MissionProgress& heard, Utime utime) {
              scene_.progress = heard;
              if (heard.surface_voxels == 0) return;
              scene_.history.push_back(
                  {Seconds(utime), static_cast<double>(heard.voxels_at_goal) / heard.surface_voxels});
            });
}

const viz::Scene& SceneHearer::Finish() {
  const ActiveSurface& surface = map_hearer_->Surface();
  scene_.incomplete_W.clear();
  scene_.low_quality_W.clear();
  const VoxelGrid& grid = surface.grid();
  for (const std::uint32_t linear : surface.elements()) {
    const Eigen::Vector3f p_W = grid.Centre(grid.FromLinear(linear)).cast<float>();
    (surface.At(linear) == SurfaceClass::kIse ? scene_.incomplete_W : scene_.low_quality_W).push_back(p_W);
  }
  return scene_;
}

}  // namespace citrine
