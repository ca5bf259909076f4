#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "core/fleet/fleet_status.h"
#include "core/trajectory/path.h"
#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"
#include "planner/fleet/divide_work.h"
#include "planner/fleet/fleet_correction.h"
#include "planner/fleet/fleet_view.h"
#include "planner/path/reachable_set.h"
#include "planner/strategy/candidate_views.h"
#include "planner/strategy/decision.h"
#include "planner/strategy/element_memory.h"
#include "planner/strategy/flown_poses.h"
#include "planner/strategy/looks.h"
#include "planner/strategy/strategy.h"

namespace citrine::planner {

/// One UAV's planner: when to decide, on what, and what to make of the outcome (paper, IV).
///
/// A decision is triggered at the start, shortly before the committed trajectory comes to rest at the goal,
/// when the goal is reached, blocked or has become worthless, and twice a second while there is none. It
/// takes effect a fixed mission time later, after those of living mates of lower id that were triggered no
/// later.
class ViewPlanner {
 public:
  /// The way to a view. nullopt: there is none
  using FindPath =
      std::function<std::optional<Path>(const Eigen::Vector3d& start_W, const Eigen::Vector3d& goal_W,
                                        const std::vector<PlanningMap::Ball>& avoid)>;

  /// @param map,surface followed, not copied  @param reachable  of the map, as far from occupied space as
  /// paths keep; it may be shared, for it is brought up to date before it is asked  @throws ConfigError for
  /// an unknown strategy
  ViewPlanner(const MissionConfig& config, int uav, const PlanningMap& map, const ActiveSurface& surface,
              std::shared_ptr<ReachableSet> reachable, FindPath find_path, LengthsBetween lengths_between);
  ~ViewPlanner();

  void HearState(int uav, const UavState& state, Utime now);
  void HearStatus(int uav, const FleetStatus& status, Utime now);
  void HearAssignment(const FleetAssignment& assignment, Utime now);
  void HearFlight(const FlightStatus& flight) { flight_ = flight; }
  void HearTrajectory(const Trajectory& trajectory) { trajectory_ = trajectory; }

  /// Follows the map and its surface, after they have changed.
  void HearMap(Utime now);

  /// Has every selection told from now on; costs the scores of all views.
  void TellDecisions(HearDecision hear) { hear_decision_ = std::move(hear); }

  /// What a step brought about.
  struct Outcome {
    bool decided = false;    ///< a decision took effect
    bool new_path = false;   ///< path() is a new one
    bool corrected = false;  ///< assignment() is a new one
    std::size_t views = 0, elements = 0;
  };
  Outcome Tick(Utime now, std::int64_t map_version);

  FleetStatus Status() const;
  /// The newest path. nullptr: none yet
  const Path* path() const { return path_ ? &*path_ : nullptr; }
  /// This UAV's own correction, while it is to be said. nullptr: none
  const FleetAssignment* assignment(Utime now) const { return correction_.OwnToRepeat(now); }

 private:
  struct Goal {
    View view;
    std::vector<std::uint32_t> seen;  ///< elements that a look from there should settle
    std::vector<std::uint32_t>
        made_for;  ///< of them, those near the one that the view was made for, and that one
    Utime deadline = 0;
    bool finished = false;  ///< reached, or as good as
    bool looked_ahead = false;
  };
  static constexpr double kBlocked_s = 4.0;  ///< until a view that could not be flown to is tried again
  struct Blocked {
    Eigen::Vector3d p_W;
    Utime until;
  };
  struct Prospect;
  /// A view that is still to be looked from while the next one is flown to.
  struct Passing {
    View view;
    Utime until;
  };
  /// Where a decision begins.
  struct Start {
    TrajectoryPoint leaves;  ///< the state in which the committed trajectory is left
    Eigen::Vector3d
        p_W;  ///< where the way to the next view begins: there, or at the view that is passed first
    bool through = false;  ///< the latter
  };

  TrajectoryPoint Ahead(Utime now) const;
  Start StartOf(Utime now) const;
  void Trigger(Utime now);
  bool GoalCallsForDecision(Utime now);
  bool GoalWorthless() const;
  bool LooksAheadNow(Utime now) const;
  /// Whether what the goal was made for will have been seen where a decision triggered now would leave.
  bool SeenOnLeaving(Utime now) const;
  void Pass(Utime now);
  void GoalBlocked(Utime now);
  bool IdleCallsForDecision(Utime now) const;
  bool MateDecidesFirst(Utime now) const;

  Outcome Decide(Utime now, std::int64_t map_version);
  Prospect LookAround(const Start& start, Utime now);
  bool Balance(const Prospect& prospect, Utime now);
  bool Unbalanced(const std::vector<Eigen::Vector3d>& elements_W, Utime now) const;
  std::optional<std::size_t> Choose(const Prospect& prospect, const Start& start, Utime now, Path& path);
  /// The way to a view, through the one that is passed first if there is one.
  std::optional<Path> FindWay(const Start& start, const View& view,
                              const std::vector<PlanningMap::Ball>& avoid);
  void Commit(const Prospect& prospect, const View& view, Path path, Utime now);
  /// Counts views that are left to an idle mate, who does not take them: after three times they are given up.
  void CountStandOffs(const Prospect& prospect, Utime now);
  void NoChoice(const Prospect& prospect, Utime now);
  /// Notes what a look should settle, this UAV's own or a mate's, to be judged when the map tells of it.
  /// @param at the view that is looked from. nullptr: looked on the way to one, or by a mate
  void RememberLook(const Eigen::Vector3d& p_W, const View* at, Utime now);
  /// The elements within the largest d*.
  std::vector<Element> ElementsNear(const Eigen::Vector3d& p_W) const;
  /// Replaces the views by those that settle most of the patch that is next on this UAV's tour. false: there
  /// are none
  bool TakeRatedViews(Prospect& prospect, const Eigen::Vector3d& p_W, SearchBudget& budget, Utime now);
  std::vector<View> OwnViewsOf(const std::vector<Element>& elements, Prospect& prospect,
                               const Eigen::Vector3d& p_W, SearchBudget& budget, Utime now);
  /// Gives up and takes out what the fleet, flying past, has looked at in vain.
  void LeaveWhatWasSeen(std::vector<Element>& elements, Utime now);
  /// The elements to which no mate is nearer.
  std::vector<Element> Mine(const Prospect& prospect, const Eigen::Vector3d& p_W) const;
  /// Whether a voxel is an element that is still to be seen.
  bool Active(std::uint32_t voxel) const;
  bool MayStand(const Eigen::Vector3d& p_W) const;
  bool Excluded(const Eigen::Vector3d& view_W, const std::vector<FleetView::Other>& others, Utime now) const;

  MissionConfig config_;
  int uav_;
  const PlanningMap& map_;
  FindPath find_path_;
  HearDecision hear_decision_;
  LengthsBetween lengths_between_;
  SensorWindow window_;
  const ActiveSurface& surface_;
  std::shared_ptr<ReachableSet> reachable_;
  ViewGenerator generator_;
  ElementMemory memory_;
  Looks looks_;
  FlownPoses flown_;
  FleetView fleet_;
  FleetCorrection correction_;
  std::unique_ptr<Strategy> strategy_;

  std::optional<UavState> state_;
  std::optional<Trajectory> trajectory_;
  FlightStatus flight_;
  std::optional<Goal> goal_;
  std::optional<Passing> passing_;
  std::optional<Path> path_;
  std::vector<Blocked> blocked_;

  std::optional<Utime> deciding_since_;
  int waited_steps_ = 0;
  Utime first_map_ = -1, last_decision_ = 0;
  std::int64_t decided_on_ = -1;  ///< map revision of the last decision
  std::int64_t decided_version_ = 0;
  std::int64_t decisions_ = 0;
  std::int32_t elements_active_ = 0;
  bool no_view_left_ = false, retry_ = false, map_is_new_ = false;
};

}  // namespace citrine::planner
