#include "modules/mcap_export/mcap_exporter.h"

#include <algorithm>
#include <string>
#include <utility>

#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/path.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/mcap_export/foxglove_words.h"
#include "viz/palette.h"

namespace citrine {

namespace {

using foxglove_words::Cloud;
using foxglove_words::Drawing;
using foxglove_words::Kind;
using foxglove_words::Said;
using foxglove_words::TopicOf;

constexpr double kFlightPeriod_s = 0.1;
constexpr double kSurfacePeriod_s = 2;  // each is the whole surface
constexpr Utime kTrajectorySpacing = 100'000;
constexpr viz::Colour kPlain{200, 205, 212};

std::string FrameOf(int uav) { return "uav" + std::to_string(uav); }

/// To a millimetre or so, by whole fractions of 2: that packs to half the size.
Eigen::Vector3f Rounded(const Eigen::Vector3d& p_W) {
  constexpr double kSteps_per_m = 1024;
  return ((p_W * kSteps_per_m).array().round() / kSteps_per_m).cast<float>();
}

Cloud CloudOf(const LidarScan& scan, viz::Colour colour) {
  Cloud cloud{"height", {}};
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const float range_m = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
      if (range_m <= 0) continue;
      const Eigen::Vector3d p_W = scan.X_WS * (range_m * scan.model.Direction(row, col));
      const Eigen::Vector3f rounded_W = Rounded(p_W);
      cloud.points.push_back({rounded_W, rounded_W.z(), colour});
    }
  return cloud;
}

/// The way from now on.
std::vector<Eigen::Vector3d> WayOf(const Trajectory& trajectory, Utime now) {
  std::vector<Eigen::Vector3d> way_W;
  for (Utime t = std::max(now, trajectory.start); t < trajectory.end(); t += kTrajectorySpacing)
    way_W.push_back(trajectory.At(t).p_W);
  if (!way_W.empty()) way_W.push_back(trajectory.At(trajectory.end()).p_W);
  return way_W;
}

}  // namespace

McapExporter::McapExporter(const ModuleContext& context, logs::McapWriter& writer)
    : config_(context.config),
      bus_(context.bus),
      writer_(writer),
      map_hearer_(context.map_hearer),
      surface_(map_hearer_->map().grid(), map_hearer_->map().quantisation(), config_.quality_goals()),
      transforms_(writer_.AddTopic(TopicOf("/tf", Kind::kTransforms))),
      surface_topic_(writer_.AddTopic(TopicOf("/map/surface", Kind::kCloud))),
      fleet_(writer_.AddTopic(TopicOf("/fleet/balance", Kind::kScene))),
      progress_topic_(writer_.AddTopic(TopicOf("/progress", Kind::kProgress))),
      flight_due_(kFlightPeriod_s),
      surface_due_(kSurfacePeriod_s),
      inboxes_(bus_),
      scans_(bus_.HearAll(channels::kLidarScan)) {
  for (int id = 1; id <= config_.mission.uavs; ++id) {
    const std::string of = "/" + FrameOf(id);
    Uav uav{};
    uav.pose = writer_.AddTopic(TopicOf(of + "/pose", Kind::kPose));
    uav.cloud = writer_.AddTopic(TopicOf(of + "/cloud", Kind::kCloud));
    uav.plan = writer_.AddTopic(TopicOf(of + "/plan", Kind::kScene));
    uav.flight = writer_.AddTopic(TopicOf(of + "/flight", Kind::kFlight));
    uavs_.push_back(std::move(uav));
  }
}

void McapExporter::Tick(const Step& step) {
  map_hearer_->Update(step);
  HearStates();
  HearScans();
  HearPlans();
  HearFleet();
  if (flight_due_.Due(step.now) || step.last) WriteFlights(step.now);
  WritePlans(step.now);
  if (surface_due_.Due(step.now) || step.last) WriteSurface(step.now);
}

void McapExporter::HearStates() {
  std::map<Utime, std::map<std::string, Pose>> X_WB_by_frame;
  HearNouns(bus_, channels::kUavState, num_uavs(), *inboxes_.states,
            [&](int id, const UavState& state, Utime utime) {
              Uav& uav = UavOf(id);
              if (uav.state) uav.flown_m += (state.X_WB.p - uav.state->X_WB.p).norm();
              uav.state = state;
              X_WB_by_frame[utime][FrameOf(id)] = state.X_WB;
              writer_.Write(uav.pose, utime, Said(utime, state.X_WB));
            });
  for (const auto& [utime, frames] : X_WB_by_frame) writer_.Write(transforms_, utime, Said(utime, frames));
}

void McapExporter::HearScans() {
  HearNouns(bus_, channels::kLidarScan, num_uavs(), *scans_, [&](int id, const LidarScan& scan, Utime) {
    const Uav& uav = UavOf(id);
    writer_.Write(uav.cloud, scan.measured, Said(scan.measured, CloudOf(scan, viz::UavColour(id))));
  });
}

void McapExporter::HearPlans() {
  HearNouns(bus_, channels::kPath, num_uavs(), *inboxes_.paths, [&](int id, const Path& path, Utime) {
    Uav& uav = UavOf(id);
    uav.plan_changed |= !uav.path || path.id != uav.path->id;
    uav.path = path;
  });
  HearNouns(bus_, channels::kTrajectory, num_uavs(), *inboxes_.trajectories,
            [&](int id, const Trajectory& trajectory, Utime) {
              Uav& uav = UavOf(id);
              uav.plan_changed |= !uav.trajectory || trajectory.id != uav.trajectory->id;
              uav.trajectory = trajectory;
            });
  HearNouns(bus_, channels::kFleetStatus, num_uavs(), *inboxes_.statuses,
            [&](int id, const FleetStatus& status, Utime) {
              Uav& uav = UavOf(id);
              uav.plan_changed |= !uav.status || status.has_goal != uav.status->has_goal ||
                                  status.goal_W != uav.status->goal_W;
              uav.status = status;
            });
}

void McapExporter::HearFleet() {
  HearNouns(bus_, channels::kFleetAssignment, *inboxes_.assignments,
            [this](const FleetAssignment& assignment, Utime utime) {
              std::vector<Drawing> centroids;
              for (int id = 1; id <= static_cast<int>(assignment.centroid_W_by_uav.size()); ++id)
                centroids.push_back({"centroid of " + FrameOf(id),
                                     viz::UavColour(id),
                                     {},
                                     0,
                                     {assignment.centroid_W_by_uav[static_cast<std::size_t>(id - 1)]},
                                     0.8});
              writer_.Write(fleet_, utime, Said(utime, centroids));
            });
  HearNouns(bus_, channels::kMissionProgress, *inboxes_.progress,
            [this](const MissionProgress& progress, Utime utime) {
              writer_.Write(progress_topic_, utime, Said(utime, progress));
            });
}

void McapExporter::WriteFlights(Utime now) {
  for (const Uav& uav : uavs_)
    if (uav.state)
      writer_.Write(uav.flight, now, Said(now, *uav.state, uav.flown_m, uav.status ? &*uav.status : nullptr));
}

void McapExporter::WritePlans(Utime now) {
  for (std::size_t i = 0; i < uavs_.size(); ++i) {
    Uav& uav = uavs_[i];
    if (!std::exchange(uav.plan_changed, false)) continue;
    const bool has_goal = uav.status && uav.status->has_goal;
    Drawing path{"path", viz::UavColour(static_cast<int>(i) + 1), {}, 0.04, {}, 0};
    Drawing goal{"goal", path.colour, {}, 0, {}, 0.6};
    Drawing trajectory{"trajectory", kPlain, {}, 0.08, {}, 0};
    if (has_goal) goal.spheres_W = {uav.status->goal_W};
    if (has_goal && uav.path)
      for (const Waypoint& waypoint : uav.path->waypoints) path.line_W.push_back(waypoint.p_W);
    if (uav.trajectory) trajectory.line_W = WayOf(*uav.trajectory, now);
    writer_.Write(uav.plan, now, Said(now, std::vector{path, goal, trajectory}));
  }
}

void McapExporter::WriteSurface(Utime now) {
  const PlanningMap& map = map_hearer_->map();
  surface_.Update(map);
  if (map.revision() == std::exchange(written_revision_, map.revision())) return;
  const VoxelGrid& grid = map.grid();
  Cloud cloud{"confidence", {}};  // as a share of w*
  for (std::size_t i = 0; i < surface_.classes().size(); ++i) {
    if (surface_.At(i) != SurfaceClass::kReached && surface_.At(i) != SurfaceClass::kLqse) continue;
    const Eigen::Vector3d p_W = grid.Centre(grid.FromLinear(i));
    const double share = std::min(map.weight(i) / config_.quality_goals().At(p_W).w_star, 1.0);
    cloud.points.push_back({p_W.cast<float>(), static_cast<float>(share), viz::ShareColour(share)});
  }
  writer_.Write(surface_topic_, now, Said(now, cloud));
}

}  // namespace citrine
