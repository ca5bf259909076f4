#include "tests/soak/soak_flight.h"

#include <algorithm>
#include <ctime>

#include "core/map/mission_grid.h"
#include "fusion/teammate_filter.h"

namespace citrine::soak {

namespace {

using Eigen::Vector3d;
using planner::FlightExecutive;
using Phase = FlightStatus::Phase;

constexpr Utime kStep = 20'000;
constexpr int kScanSteps = 5, kMapSteps = 25;
constexpr int kAccelerationSteps = 5;
constexpr double kLookahead_s = 1.4;
constexpr double kRetreat_s = 6;
constexpr int kRows = 24,
              kCols = 384;       ///< of the LiDAR: time is saved here, a thousand flights make 80 000 scans
constexpr int kFusedSteps = 10;  ///< the guard hears every scan, the map every other one
constexpr int kPlaces = 20;
constexpr std::size_t kDeadEndsMax = 8;
constexpr double kDeadEnd_m = 3, kNearby_m = 4;
constexpr double kStill_mps = 0.2;

double CpuMs() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

MissionConfig ConfigOf(const Scenario& scenario, const UavSection& uav) {
  MissionConfig config;
  config.mission.volume_min_m = Vector3d::Zero();
  config.mission.volume_max_m = scenario.size_m;
  config.mission.spawns_m = scenario.spawns_W;
  config.mission.uavs = static_cast<int>(scenario.spawns_W.size());
  config.mission.seed = static_cast<int>(scenario.seed);
  config.uav = uav;
  config.lidar.model.rows = kRows;
  config.lidar.model.cols = kCols;
  return config;
}

}  // namespace

void SoakResult::Add(const SoakResult& other) {
  flights += other.flights;
  uavs += other.uavs;
  arrived += other.arrived;
  blocked += other.blocked;
  contacts += other.contacts;
  plans += other.plans;
  failures += other.failures;
  clearance_m = std::min(clearance_m, other.clearance_m);
  separation_m = std::min(separation_m, other.separation_m);
  planned_speed_mps = std::max(planned_speed_mps, other.planned_speed_mps);
  planned_acceleration_mps2 = std::max(planned_acceleration_mps2, other.planned_acceleration_mps2);
  flown_speed_mps = std::max(flown_speed_mps, other.flown_speed_mps);
  flown_acceleration_mps2 = std::max(flown_acceleration_mps2, other.flown_acceleration_mps2);
  jump = std::max(jump, other.jump);
  error_m = std::max(error_m, other.error_m);
  seconds += other.seconds;
  smoothing_ms.insert(smoothing_ms.end(), other.smoothing_ms.begin(), other.smoothing_ms.end());
  planning_ms.insert(planning_ms.end(), other.planning_ms.begin(), other.planning_ms.end());
}

SoakFlight::SoakFlight(const Scenario& scenario, const UavSection& uav)
    : config_(ConfigOf(scenario, uav)),
      scene_(std::make_shared<sim::RayScene>(scenario.world)),
      fleet_(scenario.world.mesh, scenario.spawns_W, uav, config_.dynamics, scenario.seed),
      lidar_(scene_, config_.lidar.model, config_.lidar.noise_m_per_m2),
      fuser_(MissionGrid(config_), config_.map.truncation_m, MissionQuantisation(config_),
             fusion::WeightPolicy::kBestView),
      map_(MissionPlanningMap(config_)),
      noise_(scenario.seed, 77),
      places_(scenario.seed, 78) {
  result_.flights = 1;
  result_.uavs = fleet_.uavs();
  const auto solve = [this, smoother = planner::Smoother(config_.smoother.evaluations_max)](
                         const planner::FlightScene& scene, const planner::FlightWeights& weights,
                         const planner::SmoothingTask& task, const planner::SmoothingResult* warm) {
    const double begin_ms = CpuMs();
    planner::SmoothingResult solved = smoother.Solve(scene, weights, task, warm);
    result_.smoothing_ms.push_back(CpuMs() - begin_ms);
    return solved;
  };
  for (int id = 1; id <= fleet_.uavs(); ++id) {
    Pilot pilot;
    pilot.uav = id;
    pilot.goal_W = scenario.goals_W[static_cast<std::size_t>(id - 1)];
    pilot.retreat_W = scenario.spawns_W[static_cast<std::size_t>(id - 1)];
    planner::FlightSettings settings;
    settings.uav = id;
    settings.limits = uav.limits;
    pilot.executive = std::make_unique<FlightExecutive>(settings, map_, solve);
    pilot.executive->HearState(fleet_.state(id));
    pilot.search = std::make_unique<planner::PathSearch>(map_, uav.limits, config_.planner.path_margin_m);
    pilots_.push_back(std::move(pilot));
  }
}

SoakResult SoakFlight::Fly(double time_limit_s) {
  for (std::int64_t step = 0; now_ < FromSeconds(time_limit_s); ++step) {
    fleet_.Step(now_, Seconds(kStep));
    now_ += kStep;
    for (Pilot& pilot : pilots_) {
      pilot.said = fleet_.state(pilot.uav);
      for (int axis = 0; axis < 3; ++axis)
        pilot.said.X_WB.p(axis) += config_.uav.localisation_noise_m * noise_.Normal();
    }
    if (step % kScanSteps == 0) Scan(step % kFusedSteps == 0);
    const bool map_changed = step % kMapSteps == 1 && SayMap();
    std::vector<Trajectory> said;
    for (const Pilot& pilot : pilots_) said.push_back(*pilot.executive->committed());
    for (Pilot& pilot : pilots_) {
      for (const Pilot& other : pilots_)
        if (other.uav != pilot.uav)
          pilot.executive->HearTeammate(other.uav, said[static_cast<std::size_t>(other.uav - 1)]);
      Act(pilot, map_changed);
    }
    for (Pilot& pilot : pilots_) Measure(pilot, said[static_cast<std::size_t>(pilot.uav - 1)]);
    if (std::all_of(pilots_.begin(), pilots_.end(), [&](const Pilot& pilot) { return Arrived(pilot); }))
      break;
  }
  for (const Pilot& pilot : pilots_) {
    result_.arrived += Arrived(pilot);
    result_.contacts += fleet_.state(pilot.uav).contacts;
  }
  result_.seconds = Seconds(now_);
  return result_;
}

void SoakFlight::Scan(bool fused) {
  for (Pilot& pilot : pilots_) {
    std::vector<Vector3d> others_W;
    for (const Pilot& other : pilots_)
      if (other.uav != pilot.uav) others_W.push_back(other.said.X_WB.p);
    LidarScan scan = lidar_.Scan(now_, fleet_.state(pilot.uav).X_WB, others_W, noise_);
    scan.X_WS = pilot.said.X_WB;
    pilot.executive->HearScan(scan);
    fusion::DropTeammates(scan, others_W);
    if (fused) fuser_.Integrate(scan);
  }
}

bool SoakFlight::SayMap() {
  for (const int block : fuser_.TakeChanged()) map_.Apply(*fuser_.Said(block));
  return map_.Update();
}

void SoakFlight::Ask(Pilot& pilot) {
  const FlightStatus status = pilot.executive->Status(now_);
  const bool blocked = status.phase == Phase::kBlocked && pilot.path && status.path_id == pilot.path->id;
  const bool retreats = now_ < pilot.retreats_until;
  if (blocked && !retreats && pilot.uav > 1) {  // leaves the way to the others for a while
    pilot.retreats_until = now_ + FromSeconds(kRetreat_s);
    ++result_.blocked;
  }
  const bool over = !retreats && pilot.retreats_until > 0;
  if (over) pilot.retreats_until = -1;
  const bool short_of_goal = pilot.path && !pilot.path->ends_at_goal;
  const bool wants = !pilot.path || over || blocked || (short_of_goal && status.time_to_go_s < kLookahead_s);
  if (!wants || now_ < pilot.asks_at) return;
  pilot.asks_at = now_ + FromSeconds(0.3);
  const Vector3d from_W = pilot.executive->committed()->At(now_ + FromSeconds(0.16)).p_W;
  const Vector3d to_W = now_ < pilot.retreats_until ? pilot.retreat_W : pilot.goal_W;
  const double begin_ms = CpuMs();
  std::optional<Path> path = pilot.search->Find(from_W, to_W);
  if (path && !path->ends_at_goal && !pilot.dead_ends.empty())
    path = pilot.search->Find(from_W, to_W, pilot.dead_ends);
  pilot.search_ms = CpuMs() - begin_ms;
  // The furthest safe point is where it is: what lies beyond has to be looked at from elsewhere, and if it
  // cannot be, this is no way.
  if (!path && status.time_to_go_s == 0) {
    if (pilot.dead_ends.size() == kDeadEndsMax) pilot.dead_ends.erase(pilot.dead_ends.begin());
    pilot.dead_ends.push_back({from_W, kDeadEnd_m});
    path = LookElsewhere(pilot, from_W);
  }
  if (!path) return;
  path->id = pilot.path ? pilot.path->id + 1 : 1;
  pilot.path = std::move(path);
  pilot.executive->HearPath(*pilot.path);
}

std::optional<Path> SoakFlight::LookElsewhere(Pilot& pilot, const Vector3d& from_W) {
  const double reach_m = kNearby_m * static_cast<double>(pilot.dead_ends.size());
  for (int i = 0; i < kPlaces; ++i) {
    const Vector3d off_m(places_.Uniform(-reach_m, reach_m), places_.Uniform(-reach_m, reach_m),
                         places_.Uniform(-2, 2));
    if (off_m.norm() <= kDeadEnd_m) continue;
    const Vector3d to_W = from_W + off_m;
    std::optional<Path> path = pilot.search->Find(from_W, to_W);
    if (!path || !path->ends_at_goal) continue;
    path->ends_at_goal = false;  // it is on its way to the goal still
    return path;
  }
  return std::nullopt;
}

void SoakFlight::Act(Pilot& pilot, bool map_changed) {
  pilot.search_ms = 0;
  Ask(pilot);
  const double begin_ms = CpuMs();
  pilot.executive->Act(now_, map_changed);
  const Trajectory& committed = *pilot.executive->committed();
  if (pilot.executive->planned()) {
    result_.planning_ms.push_back(pilot.search_ms + CpuMs() - begin_ms);
    ++result_.plans;
    result_.failures += pilot.executive->Status(now_).failures > 0;
  }
  if (committed.id == pilot.followed) return;
  pilot.followed = committed.id;
  fleet_.Follow(pilot.uav, committed);
}

void SoakFlight::Measure(Pilot& pilot, const Trajectory& before) {
  const UavState& state = fleet_.state(pilot.uav);
  const TrajectoryPoint old = before.At(now_), asked = pilot.executive->committed()->At(now_);
  result_.jump = std::max({result_.jump, (old.p_W - asked.p_W).norm(), (old.v_W - asked.v_W).norm(),
                           (old.a_W - asked.a_W).norm()});
  result_.planned_speed_mps = std::max(result_.planned_speed_mps, asked.v_W.norm());
  result_.planned_acceleration_mps2 = std::max(result_.planned_acceleration_mps2, asked.a_W.norm());
  result_.error_m = std::max(result_.error_m, (state.X_WB.p - asked.p_W).norm());
  result_.flown_speed_mps = std::max(result_.flown_speed_mps, state.v_W.norm());
  pilot.velocities_W.push_back(state.v_W);
  const std::size_t n = pilot.velocities_W.size();
  if (n > kAccelerationSteps)
    result_.flown_acceleration_mps2 = std::max(
        result_.flown_acceleration_mps2, (state.v_W - pilot.velocities_W[n - 1 - kAccelerationSteps]).norm() /
                                             (kAccelerationSteps * Seconds(kStep)));
  result_.clearance_m = std::min(result_.clearance_m, scene_->Distance(state.X_WB.p, 5));
  for (const Pilot& other : pilots_)
    if (other.uav < pilot.uav)
      result_.separation_m =
          std::min(result_.separation_m, (state.X_WB.p - fleet_.state(other.uav).X_WB.p).norm());
}

bool SoakFlight::Arrived(const Pilot& pilot) const {
  const UavState& state = fleet_.state(pilot.uav);
  return (state.X_WB.p - pilot.goal_W).norm() <= kReached_m + 0.1 && state.v_W.norm() < kStill_mps;
}

}  // namespace citrine::soak
