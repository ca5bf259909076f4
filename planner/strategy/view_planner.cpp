#include "planner/strategy/view_planner.h"

#include <algorithm>

#include "planner/fleet/balance.h"
#include "planner/strategy/strategies.h"
#include "planner/view/well_seen.h"

namespace citrine::planner {

namespace {

constexpr double kNearGoal_m = 0.3;  ///< a trajectory that ends this near leads to the goal
constexpr double kIdlePeriod_s = 0.5;
constexpr double kStalled_s = 2.0;
constexpr double kLate_s =
    2.0;  ///< after it would have been at rest there, a view that was to be passed is given up
constexpr int kWaitSteps = 5;
constexpr double kLittle = 0.25;  ///< share of a goal's elements below which little gain is left

double SettleTime(const MissionConfig& config) {
  return 1 / config.lidar.rate_hz + 1 / config.map.publish_hz + 0.4;
}

}  // namespace

ViewPlanner::ViewPlanner(const MissionConfig& config, int uav, const PlanningMap& map,
                         const ActiveSurface& surface, std::shared_ptr<ReachableSet> reachable,
                         FindPath find_path, LengthsBetween lengths_between)
    : config_(config),
      uav_(uav),
      map_(map),
      find_path_(std::move(find_path)),
      lengths_between_(std::move(lengths_between)),
      window_(config.lidar.model),
      surface_(surface),
      reachable_(std::move(reachable)),
      generator_(map, window_, [this](const Eigen::Vector3d& p_W) { return MayStand(p_W); },
                 {config.quality.eta_m, config.map.weight_policy != "best_view"}),
      memory_(map.grid(), config.lidar.model.range_max_m),
      looks_(SettleTime(config)),
      flown_(config.mission.uavs),
      fleet_(uav, config.mission.uavs),
      correction_(uav, config.planner.corrected_selections, config.planner.correction_expiry_s),
      strategy_(MakeStrategy(config.planner)) {}

ViewPlanner::~ViewPlanner() = default;

void ViewPlanner::HearState(int uav, const UavState& state, Utime now) {
  flown_.Add(uav, state.X_WB, now);
  if (uav == uav_)
    state_ = state;
  else
    fleet_.Hear(uav, state, now);
}

void ViewPlanner::HearStatus(int uav, const FleetStatus& status, Utime now) {
  if (uav != uav_) fleet_.Hear(uav, status, now);
}

void ViewPlanner::HearAssignment(const FleetAssignment& assignment, Utime now) {
  if (static_cast<int>(assignment.centroid_W_by_uav.size()) == config_.mission.uavs)
    correction_.Hear(assignment, now);
}

void ViewPlanner::HearMap(Utime now) {
  if (first_map_ < 0) first_map_ = now;
  memory_.Update(map_, surface_);
  map_is_new_ = true;
}

bool ViewPlanner::Active(std::uint32_t voxel) const {
  return surface_.At(voxel) >= SurfaceClass::kLqse && !memory_.Skips(voxel);
}

bool ViewPlanner::MayStand(const Eigen::Vector3d& p_W) const {
  return reachable_->Reaches(p_W) && reachable_->space().Safe(p_W);
}

TrajectoryPoint ViewPlanner::Ahead(Utime now) const {
  if (trajectory_) return trajectory_->At(now + FromSeconds(config_.smoother.replan_ahead_s + 0.04));
  TrajectoryPoint point;
  point.p_W = state_->X_WB.p;
  point.v_W = state_->v_W;
  return point;
}

ViewPlanner::Start ViewPlanner::StartOf(Utime now) const {
  Start start{Ahead(now), {}};
  start.through = passing_ && (start.leaves.p_W - passing_->view.p_W).norm() > kReached_m;
  start.p_W = start.through ? passing_->view.p_W : start.leaves.p_W;
  return start;
}

ViewPlanner::Outcome ViewPlanner::Tick(Utime now, std::int64_t map_version) {
  Outcome outcome;
  if (!state_ || first_map_ < 0) return outcome;
  correction_.Update(fleet_.Mates(now), now);
  for (const Eigen::Vector3d& look_W : fleet_.TakeLooks()) RememberLook(look_W, nullptr, now);
  if (looks_.Judge(map_, surface_, now, memory_)) retry_ = true;
  if (passing_) Pass(now);
  if (!deciding_since_ && (goal_ ? GoalCallsForDecision(now) : IdleCallsForDecision(now))) Trigger(now);
  map_is_new_ = false;
  if (!deciding_since_ || now < *deciding_since_ + FromSeconds(config_.planner.decision_latency_s))
    return outcome;
  if (waited_steps_ < kWaitSteps && MateDecidesFirst(now)) {
    ++waited_steps_;
    return outcome;
  }
  outcome = Decide(now, map_version);
  deciding_since_.reset();
  return outcome;
}

void ViewPlanner::Trigger(Utime now) {
  deciding_since_ = now;
  waited_steps_ = 0;
  if (!config_.planner.balance || config_.mission.uavs < 2 || !correction_.MayBegin(fleet_.Mates(now), now))
    return;
  std::vector<Eigen::Vector3d> elements_W;
  for (const std::uint32_t voxel : surface_.elements())
    if (!memory_.Skips(voxel)) elements_W.push_back(map_.grid().Centre(map_.grid().FromLinear(voxel)));
  if (Unbalanced(elements_W, now)) correction_.Claim();
}

bool ViewPlanner::GoalCallsForDecision(Utime now) {
  const Eigen::Vector3d& goal_W = goal_->view.p_W;
  const bool mine = flight_.path_id == path_->id;
  if ((state_->X_WB.p - goal_W).norm() <= kReached_m ||
      (mine && flight_.phase == FlightStatus::Phase::kReached)) {
    goal_->finished = true;
    passing_.reset();
    return true;
  }
  const bool stalled =
      trajectory_ && trajectory_->path_id == path_->id && trajectory_->end() + FromSeconds(kStalled_s) < now;
  if ((mine && flight_.phase == FlightStatus::Phase::kBlocked) || stalled || now > goal_->deadline) {
    GoalBlocked(now);
    return true;
  }
  if (LooksAheadNow(now)) {
    goal_->looked_ahead = true;
    if (SeenOnLeaving(now))
      goal_->finished = true;
    else
      passing_ = Passing{goal_->view, trajectory_->end() + FromSeconds(kLate_s)};
    return true;
  }
  return map_is_new_ && GoalWorthless();
}

bool ViewPlanner::LooksAheadNow(Utime now) const {
  if (goal_->looked_ahead || passing_ || !trajectory_ || trajectory_->path_id != path_->id) return false;
  const Utime end = trajectory_->end();
  if (end > now + FromSeconds(config_.planner.lookahead_s)) return false;
  return (trajectory_->At(end).p_W - goal_->view.p_W).norm() <= kNearGoal_m;
}

bool ViewPlanner::SeenOnLeaving(Utime now) const {
  const Eigen::Vector3d p_W = Ahead(now + FromSeconds(config_.planner.decision_latency_s)).p_W;
  const std::vector<Element> left = ListElements(
      map_, surface_, [&](std::uint32_t voxel) { return voxel != goal_->view.element || !Active(voxel); });
  return left.empty() || WellSeen(map_, left.front(), window_, p_W);
}

void ViewPlanner::Pass(Utime now) {
  const View view = passing_->view;
  const bool there = (state_->X_WB.p - view.p_W).norm() <= kReached_m;
  if (there) RememberLook(view.p_W, &view, now);
  if (there || now > passing_->until) passing_.reset();
}

bool ViewPlanner::GoalWorthless() const {
  const auto active = [this](std::uint32_t voxel) { return Active(voxel); };
  if (std::any_of(goal_->made_for.begin(), goal_->made_for.end(), active)) return false;
  const auto left = std::count_if(goal_->seen.begin(), goal_->seen.end(), active);
  return static_cast<double>(left) <= kLittle * static_cast<double>(goal_->seen.size());
}

void ViewPlanner::GoalBlocked(Utime now) {
  blocked_.push_back({goal_->view.p_W, now + FromSeconds(kBlocked_s)});
  memory_.CountBlocked(map_, goal_->view.element);
  goal_.reset();
  passing_.reset();
}

bool ViewPlanner::IdleCallsForDecision(Utime now) const {
  if (decisions_ == 0 && decided_on_ < 0) return true;
  if (now < last_decision_ + FromSeconds(kIdlePeriod_s)) return false;
  return retry_ || map_.revision() != decided_on_;
}

bool ViewPlanner::MateDecidesFirst(Utime now) const {
  for (const FleetView::Other& other : fleet_.Alive(now))
    if (other.uav < uav_ && other.deciding && other.deciding_since <= *deciding_since_) return true;
  return false;
}

bool ViewPlanner::Unbalanced(const std::vector<Eigen::Vector3d>& elements_W, Utime now) const {
  std::vector<Eigen::Vector3d> uavs_W{state_->X_WB.p};
  for (const FleetView::Other& other : fleet_.Alive(now)) uavs_W.push_back(other.x_W());
  return planner::Unbalanced(elements_W, uavs_W, config_.planner.correction_starved);
}

FleetStatus ViewPlanner::Status() const {
  FleetStatus status;
  if (state_) status.X_WB = state_->X_WB;
  status.activity = deciding_since_ ? FleetStatus::Activity::kDeciding
                    : goal_         ? FleetStatus::Activity::kFlying
                                    : FleetStatus::Activity::kIdle;
  status.deciding_since = deciding_since_.value_or(0);
  status.has_goal = goal_.has_value();
  if (goal_) {
    status.goal_W = goal_->view.p_W;
    status.goal_yaw_rad = goal_->view.yaw_rad;
  }
  status.decisions = decisions_;
  status.replanning = correction_.replanning();
  status.plan_id = correction_.plan_id();
  status.corrected_selections_left = correction_.selections_left();
  status.map_version = decided_version_;
  status.elements_active = elements_active_;
  status.elements_unreachable = memory_.unreachable();
  status.elements_given_up = memory_.given_up();
  status.no_view_left = no_view_left_;
  return status;
}

}  // namespace citrine::planner
