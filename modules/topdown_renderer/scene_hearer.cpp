#include "modules/topdown_renderer/scene_hearer.h"

#include <algorithm>
#include <utility>

#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/path.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/map_hearer.h"

namespace citrine {

namespace {
constexpr double kTrailSpacing_m = 0.1;
}

SceneHearer::SceneHearer(const ModuleContext& context)
    : bus_(context.bus),
      map_hearer_(context.map_hearer),
      surface_(map_hearer_->map().grid(), map_hearer_->map().quantisation(), context.config.quality_goals()),
      states_(bus_.HearAll(channels::kUavState)),
      paths_(bus_.HearAll(channels::kPath)),
      trajectories_(bus_.HearAll(channels::kTrajectory)),
      statuses_(bus_.HearAll(channels::kFleetStatus)),
      assignments_(bus_.Hear(channels::kFleetAssignment)),
      progress_(bus_.Hear(channels::kMissionProgress)) {
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

template <class Message, class Take>
void SceneHearer::Hear(const UavChannel<Message>& channel, Inbox<Message>& inbox, const Take& take) {
  for (auto& [id, message] : inbox.Take()) {
    if (id < 1 || id > static_cast<int>(scene_.uavs.size())) continue;
    try {
      take(scene_.uavs[static_cast<std::size_t>(id - 1)], Decode(message));
    } catch (const BadMessage& error) {
      bus_.Reject(channel.Of(id), error.what());
    }
  }
}

void SceneHearer::Update(const Step& step) {
  scene_.now = step.now;
  map_hearer_->Update(step);
  HearStates();
  HearPlans();
  HearAssignments();
  HearProgress();
}

void SceneHearer::HearStates() {
  Hear(channels::kUavState, *states_, [](viz::SceneUav& uav, const UavState& state) {
    uav.state = state;
    const Eigen::Vector3d& p_W = state.X_WB.p;
    const double moved_m = uav.trail_W.empty() ? 0 : (p_W - uav.trail_W.back()).norm();
    if (!uav.trail_W.empty() && moved_m < kTrailSpacing_m) return;
    uav.trail_W.push_back(p_W);
    uav.flown_m += moved_m;
  });
}

void SceneHearer::HearPlans() {
  Hear(channels::kPath, *paths_, [](viz::SceneUav& uav, Path&& path) { uav.path = std::move(path); });
  Hear(channels::kTrajectory, *trajectories_, [](viz::SceneUav& uav, Trajectory&& trajectory) {
    if (!uav.trajectory || Supersedes(trajectory, *uav.trajectory)) uav.trajectory = std::move(trajectory);
  });
  Hear(channels::kFleetStatus, *statuses_,
       [](viz::SceneUav& uav, const FleetStatus& status) { uav.status = status; });
}

void SceneHearer::HearAssignments() {
  for (const auto& entry : assignments_->Take()) {
    try {
      const FleetAssignment assignment = Decode(entry.message);
      if (assignment.plan_id < newest_plan_) continue;
      newest_plan_ = assignment.plan_id;
      assignment_expiry_ = assignment.expiry;
      for (std::size_t i = 0; i < std::min(scene_.uavs.size(), assignment.centroid_W_by_uav.size()); ++i) {
        scene_.uavs[i].centroid_W = assignment.centroid_W_by_uav[i];
      }
    } catch (const BadMessage& error) {
      bus_.Reject(channels::kFleetAssignment.name, error.what());
    }
  }
  for (viz::SceneUav& uav : scene_.uavs) {
    const bool over =
        uav.status && uav.status->plan_id == newest_plan_ && uav.status->corrected_selections_left == 0;
    if (over || scene_.now > assignment_expiry_) uav.centroid_W.reset();
  }
}

void SceneHearer::HearProgress() {
  for (const auto& entry : progress_->Take()) {
    try {
      scene_.progress = Decode(entry.message);
    } catch (const BadMessage& error) {
      bus_.Reject(channels::kMissionProgress.name, error.what());
      continue;
    }
    const MissionProgress& progress = scene_.progress;
    if (progress.surface_voxels == 0) continue;
    scene_.history.push_back({Seconds(entry.message.utime),
                              static_cast<double>(progress.voxels_at_goal) / progress.surface_voxels});
  }
}

const viz::Scene& SceneHearer::Finish() {
  surface_.Update(map_hearer_->map());
  scene_.incomplete_W.clear();
  scene_.low_quality_W.clear();
  const VoxelGrid& grid = surface_.grid();
  for (const std::uint32_t linear : surface_.elements()) {
    const Eigen::Vector3f p_W = grid.Centre(grid.FromLinear(linear)).cast<float>();
    (surface_.At(linear) == SurfaceClass::kIse ? scene_.incomplete_W : scene_.low_quality_W).push_back(p_W);
  }
  return scene_;
}

}  // namespace citrine
