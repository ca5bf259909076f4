#include "planner/safety/flight_executive.h"

#include <algorithm>
#include <utility>

#include "planner/trajectory/brake.h"
#include "planner/trajectory/trajectory_cut.h"

namespace citrine::planner {

namespace {

constexpr Utime kRetry = 500'000;
constexpr Utime kPatience = 2'000'000;  ///< at rest short of the path's end
constexpr double kCommitHorizon_s = 6;  ///< in which a new trajectory must stay clear of the newest scan
constexpr int kFailuresMax = 3;
constexpr Utime kSample = 50'000, kInstant = 20'000;
constexpr double kClearer_m = 0.01;
constexpr double kAtRest_mps =
    0.2;  ///< of one that takes over in flight: what was committed before ends at rest
constexpr double kThere_m = 0.02;  ///< a path's end this near to where the UAV hovers is not worth a motion

}  // namespace

FlightExecutive::FlightExecutive(const FlightSettings& settings, const PlanningMap& map, SolveMotion solve)
    : settings_(settings),
      planner_(map, settings.limits, settings.path_margin_m, settings.weights, std::move(solve)),
      guard_(settings.uav, settings.limits),
      guard_due_(1 / settings.guard_hz) {
  scene_.map = &map;
  scene_.limits = settings.limits;
}

void FlightExecutive::HearPath(const Path& path) {
  if (has_path_ && path.id <= path_.id) return;
  const std::optional<Eigen::Vector3d> former_end_W =
      path_.waypoints.empty() ? std::nullopt : std::optional(path_.waypoints.back().p_W);
  const auto leads_through = [&](const std::optional<Eigen::Vector3d>& p_W) {
    return p_W && path.waypoints.size() > 2 &&
           std::any_of(path.waypoints.begin() + 1, path.waypoints.end() - 1,
                       [&](const Waypoint& waypoint) { return waypoint.p_W == *p_W; });
  };
  if (!leads_through(pass_W_)) pass_W_ = leads_through(former_end_W) ? former_end_W : std::nullopt;
  path_ = path;
  path_is_new_ = has_path_ = true;
}

void FlightExecutive::HearState(const UavState& state) {
  if (committed_ || state.v_W.norm() > kAtRest_mps) return;
  committed_ = Hover(state.X_WB.p, YawOf(state.X_WB.q), state.utime);
  committed_->id = ++trajectories_;
}

void FlightExecutive::HearTeammate(int uav, const Trajectory& trajectory) {
  if (uav == settings_.uav || trajectory.segments.empty()) return;
  const auto known = std::find_if(scene_.teammates.begin(), scene_.teammates.end(),
                                  [uav](const Teammate& teammate) { return teammate.uav >= uav; });
  if (known == scene_.teammates.end() || known->uav != uav)
    scene_.teammates.insert(known, {uav, trajectory});
  else if (Supersedes(trajectory, known->trajectory))
    known->trajectory = trajectory;
}

void FlightExecutive::HearTeammate(int uav, const UavState& state) {
  const bool known = std::any_of(scene_.teammates.begin(), scene_.teammates.end(),
                                 [uav](const Teammate& teammate) { return teammate.uav == uav; });
  if (!known) HearTeammate(uav, Hover(state.X_WB.p, YawOf(state.X_WB.q), state.utime));
}

void FlightExecutive::Act(Utime now, bool map_changed) {
  planned_ = false;
  if (!committed_) return;
  if (pass_W_ && Passes(now, now)) pass_W_.reset();
  if (std::exchange(path_is_new_, false)) {
    failures_ = 0;
    blocked_ = false;
    waiting_since_ = -1;
    reason_.clear();
    if (path_.waypoints.empty())
      Brake(now, "told to stop");
    else if (!Replan(now))
      CountFailure(now);
  }
  if (map_changed && !AtRest(now))
    if (const auto violation = FindMapViolation(*committed_, now, scene_)) React(now, violation->Reason());
  if (guard_due_.Due(now)) {
    const GuardVerdict verdict = guard_.Check(*committed_, now, scene_);
    if (verdict.action != GuardVerdict::Action::kOk) React(now, verdict.why);
  }
  Retry(now);
}

bool FlightExecutive::Replan(Utime now) {
  planned_ = true;
  if (AtRest(now) && (committed_->At(now).p_W - path_.waypoints.back().p_W).norm() <= kThere_m) {
    Trajectory there = Hover(committed_->At(now).p_W, committed_->At(now).yaw_rad, now);
    there.path_id = path_.id;
    Commit(std::move(there), false);
    return true;
  }
  const Utime at = now + FromSeconds(settings_.replan_ahead_s);
  const bool passes = pass_W_ && !Passes(now, at);
  const FlightPlanner::Task task{*committed_, now, at, path_, passes ? pass_W_ : std::nullopt, scene_};
  const auto accept = [&](const Trajectory& found) {
    return !guard_.FindHit(found, task.at, scene_, kCommitHorizon_s);
  };
  std::optional<Trajectory> found = planner_.Plan(task, accept, &reason_);
  if (!found) return false;
  Commit(std::move(*found), false);
  retry_at_ = now + kRetry;
  return true;
}

void FlightExecutive::Retry(Utime now) {
  if (!has_path_ || path_.waypoints.empty() || HeadsForPathEnd() || PathFinished(now)) {
    waiting_since_ = -1;
    return;
  }
  if (AtRest(now) && waiting_since_ < 0) waiting_since_ = now;
  if (waiting_since_ >= 0 && now - waiting_since_ >= kPatience) blocked_ = true;
  if (now < retry_at_ || (braking_ && !AtRest(now))) return;
  if (!Replan(now)) CountFailure(now);
}

void FlightExecutive::CountFailure(Utime now) {
  ++failures_;
  retry_at_ = now + kRetry;
  if (failures_ >= kFailuresMax) blocked_ = true;
}

void FlightExecutive::React(Utime now, const std::string& why) {
  if (AtRest(now)) return;
  const bool has_goal = has_path_ && !path_.waypoints.empty() && committed_->path_id == path_.id;
  if (has_goal && !braking_ && Replan(now)) return;
  Brake(now, why);
}

void FlightExecutive::Brake(Utime now, const std::string& why) {
  reason_ = why;
  if (AtRest(now)) return;
  const Utime at = now + FromSeconds(settings_.replan_ahead_s);
  const Trajectory onward = Onward(committed_->At(at), at);
  const std::vector<TrajectorySegment> ways[] = {
      BrakeAlong(*committed_, at, settings_.limits, Braking::kGentle),
      BrakeAlong(*committed_, at, settings_.limits, Braking::kHard),
      BrakeAlong(onward, at, settings_.limits, Braking::kHard)};
  std::optional<Trajectory> best;
  double best_m = braking_ ? LeastClearance(*committed_, now) : -1e9;
  for (const std::vector<TrajectorySegment>& way : ways) {
    Trajectory brake = Splice(*committed_, now, at, way);
    brake.path_id = path_.id;
    if (!FindViolation(brake, now, scene_) && !guard_.FindHit(brake, now, scene_)) {
      best = std::move(brake);
      break;
    }
    const double clearance_m = LeastClearance(brake, now);
    if (clearance_m > best_m + kClearer_m) best_m = clearance_m, best = std::move(brake);
  }
  if (best) Commit(std::move(*best), true);
}

double FlightExecutive::LeastClearance(const Trajectory& trajectory, Utime from) const {
  double least_m = 1e9;
  for (Utime t = from; t < trajectory.end() + kSample; t += kSample) {
    const Eigen::Vector3d p_W = trajectory.At(t).p_W;
    least_m = std::min(
        {least_m, scene_.map->to_occupied().Interpolate(p_W), scene_.map->to_unknown().Interpolate(p_W)});
    for (const Teammate& teammate : scene_.teammates)
      least_m = std::min(least_m, (teammate.trajectory.At(t).p_W - p_W).norm() - settings_.limits.radius_m);
  }
  return least_m;
}

void FlightExecutive::Commit(Trajectory trajectory, bool braking) {
  trajectory.id = ++trajectories_;
  committed_ = std::move(trajectory);
  braking_ = braking;
  if (braking) return;
  failures_ = 0;
  blocked_ = false;
  waiting_since_ = -1;
  reason_.clear();
}

bool FlightExecutive::HeadsForPathEnd() const {
  if (!has_path_ || path_.waypoints.empty() || committed_->path_id != path_.id) return false;
  return (committed_->At(committed_->end()).p_W - path_.waypoints.back().p_W).norm() <= kReached_m;
}

bool FlightExecutive::Passes(Utime from, Utime to) const {
  for (Utime t = from;; t = std::min(t + kInstant, to)) {
    if ((committed_->At(t).p_W - *pass_W_).norm() <= kReached_m) return true;
    if (t >= to) return false;
  }
}

bool FlightExecutive::PathFinished(Utime now) const {
  return has_path_ && !path_.waypoints.empty() && committed_->path_id == path_.id &&
         (committed_->At(now).p_W - path_.waypoints.back().p_W).norm() <= kReached_m;
}

FlightStatus FlightExecutive::Status(Utime now) const {
  FlightStatus status;
  status.path_id = has_path_ ? path_.id : 0;
  if (!committed_) return status;
  using Phase = FlightStatus::Phase;
  const bool asked = has_path_ && !path_.waypoints.empty();
  if (asked && PathFinished(now))
    status.phase = Phase::kReached;
  else if (asked && blocked_)
    status.phase = Phase::kBlocked;
  else if (braking_ && !AtRest(now))
    status.phase = Phase::kBraking;
  else if (asked)
    status.phase = Phase::kTracking;
  if (status.phase == Phase::kBraking || status.phase == Phase::kBlocked) status.reason = reason_;
  status.trajectory_id = committed_->id;
  status.failures = failures_;
  status.time_to_go_s = std::max(0.0, Seconds(committed_->end() - now));
  for (Utime t = now; t < committed_->end(); t += kSample)
    status.distance_to_go_m += (committed_->At(t + kSample).p_W - committed_->At(t).p_W).norm();
  return status;
}

}  // namespace citrine::planner
