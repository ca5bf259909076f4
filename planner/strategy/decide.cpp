#include <algorithm>

#include "core/parallel_for.h"
#include "planner/fleet/balance.h"
#include "planner/path/tour.h"
#include "planner/strategy/strays.h"
#include "planner/strategy/view_planner.h"
#include "planner/view/rated_views.h"
#include "planner/view/shortlist.h"
#include "planner/view/well_seen.h"

namespace citrine::planner {

namespace {

constexpr double kGroup_m = 0.75;      ///< elements this near to a view's own share it (a cell of 3 voxels)
constexpr double kGoalsApart_m = 0.5;  ///< beyond two radii
constexpr double kBlockedNear_m = 0.5;
constexpr double kStandOff_s = 3.0;         ///< until a view that an idle mate stands by is asked for again
constexpr double kWarmUp_s = 3.0;           ///< before it the map is too young to say that nothing is left
constexpr int kLooksEnough = 3;             ///< in passing, that should each have settled an element
constexpr int kParts = 8;                   ///< that threads take, of the elements
constexpr std::size_t kLeftToMates = 100;   ///< elements nearer to mates that are still at work
constexpr int kFans = 300, kLattices = 40;  ///< searched in a decision; more by a UAV without a goal
constexpr int kFansIdle = 1000, kLatticesIdle = 150;

}  // namespace

/// What a decision sees.
struct ViewPlanner::Prospect {
  std::vector<Element> elements;  ///< active, and not as good as seen
  bool some_taken = false;        ///< others are about to be seen, by this UAV or a mate
  Candidates candidates;          ///< of all elements, or of those that no pose of a patch settles
  std::vector<View> views;        ///< up for choice: may be flown to at present
  bool is_left_to_mates = false;  ///< untested
  std::vector<FleetView::Other> others;
};

ViewPlanner::Outcome ViewPlanner::Decide(Utime now, std::int64_t map_version) {
  const Start start = StartOf(now);
  reachable_->Update(start.leaves.p_W);
  blocked_.erase(
      std::remove_if(blocked_.begin(), blocked_.end(), [&](const Blocked& b) { return b.until <= now; }),
      blocked_.end());
  last_decision_ = now;
  decided_on_ = map_.revision();
  decided_version_ = map_version;
  retry_ = false;

  const Prospect prospect = LookAround(start, now);
  Outcome outcome;
  outcome.decided = true;
  outcome.corrected = Balance(prospect, now);
  outcome.views = prospect.views.size();
  outcome.elements = prospect.elements.size();

  Path path;
  const std::optional<std::size_t> choice = Choose(prospect, start, now, path);
  if (choice) {
    Commit(prospect, prospect.views[*choice], std::move(path), now);
    outcome.new_path = true;
  } else {
    NoChoice(prospect, now);
  }
  return outcome;
}

ViewPlanner::Prospect ViewPlanner::LookAround(const Start& start, Utime now) {
  Prospect prospect;
  prospect.others = fleet_.Alive(now);
  prospect.elements = ListElements(map_, surface_, [&](std::uint32_t voxel) { return memory_.Skips(voxel); });
  elements_active_ = static_cast<std::int32_t>(prospect.elements.size());
  if (goal_ && goal_->finished) {
    const bool there = (state_->X_WB.p - goal_->view.p_W).norm() < 0.5;
    RememberLook(there ? state_->X_WB.p : start.p_W, there ? &goal_->view : nullptr, now);
  }

  std::vector<std::uint32_t> taken;
  looks_.AppendTo(taken);
  const auto take = [&](const Eigen::Vector3d& p_W) {
    const std::vector<std::uint32_t> seen = WellSeenFrom(map_, prospect.elements, window_, p_W);
    taken.insert(taken.end(), seen.begin(), seen.end());
  };
  if (passing_) take(passing_->view.p_W), taken.push_back(passing_->view.element);
  for (const FleetView::Other& other : prospect.others) {
    if (other.has_goal) take(other.goal_W);
  }
  std::sort(taken.begin(), taken.end());
  const auto is_taken = [&](const Element& e) {
    return std::binary_search(taken.begin(), taken.end(), e.linear);
  };
  const auto kept = std::remove_if(prospect.elements.begin(), prospect.elements.end(), is_taken);
  prospect.some_taken = kept != prospect.elements.end();
  prospect.elements.erase(kept, prospect.elements.end());
  LeaveWhatWasSeen(prospect.elements, now);
  // Where weights are summed, those that lack a little are scattered over all that was seen from afar.
  if (config_.map.weight_policy == "best_view")
    LeaveStrays(prospect.elements, map_.grid(), config_.planner.strays_m);
  for (Element& element : prospect.elements) element.attempts = memory_.Attempts(element.linear);

  SearchBudget budget{goal_ ? kFans : kFansIdle, goal_ ? kLattices : kLatticesIdle};
  if (!TakeRatedViews(prospect, start.p_W, budget, now)) {
    prospect.candidates = {};
    prospect.views = OwnViewsOf(prospect.elements, prospect, start.p_W, budget, now);
    LeaveNearOnes(prospect.views, start.p_W, config_.planner.hop_min_m);
  }
  return prospect;
}

/// Adds to the candidates. @return those that are not excluded
std::vector<View> ViewPlanner::OwnViewsOf(const std::vector<Element>& elements, Prospect& prospect,
                                          const Eigen::Vector3d& p_W, SearchBudget& budget, Utime now) {
  Candidates own =
      MakeCandidates(map_, elements, generator_, config_.planner.views == "per_cell", p_W, budget, memory_);
  std::vector<View>& all = prospect.candidates.views;
  all.insert(all.end(), own.views.begin(), own.views.end());
  prospect.candidates.untested += own.untested;
  std::erase_if(own.views, [&](const View& view) { return Excluded(view.p_W, prospect.others, now); });
  return std::move(own.views);
}

bool ViewPlanner::TakeRatedViews(Prospect& prospect, const Eigen::Vector3d& p_W, SearchBudget& budget,
                                 Utime now) {
  if (config_.planner.candidates == "all" || config_.planner.strategy != "quality_adaptive") return false;
  std::vector<Element> mine = Mine(prospect, p_W);
  if (mine.empty()) {
    const bool mates_work = std::any_of(prospect.others.begin(), prospect.others.end(),
                                        [](const FleetView::Other& other) { return other.has_goal; });
    prospect.is_left_to_mates = mates_work && prospect.elements.size() < kLeftToMates;
    if (prospect.is_left_to_mates) return true;
    mine = prospect.elements;
  }
  const std::vector<Patch> patches = PatchesOf(mine);
  std::vector<Eigen::Vector3d> centres_W;
  for (const Patch& patch : patches) centres_W.push_back(patch.centre_W);
  const auto allowed = [&](const Eigen::Vector3d& view_W) {
    return MayStand(view_W) && !Excluded(view_W, prospect.others, now);
  };
  const auto own_views = [&](const std::vector<std::size_t>& which) {
    std::vector<Element> elements;
    for (const std::size_t i : which) elements.push_back(mine[i]);
    return OwnViewsOf(elements, prospect, p_W, budget, now);
  };
  for (const std::size_t next : ShortTour(p_W, centres_W)) {
    prospect.views = RatedViews(map_, window_, mine, patches[next], own_views, allowed, p_W);
    if (!prospect.views.empty()) return true;
  }
  return false;
}

void ViewPlanner::LeaveWhatWasSeen(std::vector<Element>& elements, Utime now) {
  const Utime before = now - looks_.settle_time();
  std::vector<std::uint8_t> was_seen(elements.size(), 0);
  ParallelForEach(elements.size(), kParts, [&](std::size_t i) {
    was_seen[i] = elements[i].kind == SurfaceClass::kLqse &&
                  flown_.Looks(map_, elements[i], window_, before, kLooksEnough) >= kLooksEnough;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (was_seen[i])
      memory_.GiveUp(map_, elements[i].linear);
    else
      elements[kept++] = elements[i];
  }
  elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(kept), elements.end());
}

std::vector<Element> ViewPlanner::Mine(const Prospect& prospect, const Eigen::Vector3d& p_W) const {
  std::vector<Element> mine;
  for (const Element& element : prospect.elements) {
    const auto nearer = [&](const FleetView::Other& other) {
      return (other.x_W() - element.p_W).norm() < (p_W - element.p_W).norm();
    };
    if (std::none_of(prospect.others.begin(), prospect.others.end(), nearer)) mine.push_back(element);
  }
  return mine;
}

void ViewPlanner::RememberLook(const Eigen::Vector3d& p_W, const View* at, Utime now) {
  std::vector<std::uint32_t> seen = WellSeenFrom(map_, ElementsNear(p_W), window_, p_W);
  if (at && Active(at->element) && !std::binary_search(seen.begin(), seen.end(), at->element))
    seen.push_back(at->element);
  std::vector<ElementMemory::Before> before;
  for (const std::uint32_t voxel : seen) before.push_back(memory_.Note(map_, voxel));
  looks_.Add(std::move(before), map_.revision(), now);
}

std::vector<Element> ViewPlanner::ElementsNear(const Eigen::Vector3d& p_W) const {
  const double near_m = surface_.goals().d_star_max();
  return ListElements(map_, surface_, [&](std::uint32_t voxel) {
    return memory_.Skips(voxel) ||
           (map_.grid().Centre(map_.grid().FromLinear(voxel)) - p_W).squaredNorm() > near_m * near_m;
  });
}

bool ViewPlanner::Excluded(const Eigen::Vector3d& view_W, const std::vector<FleetView::Other>& others,
                           Utime now) const {
  for (const Blocked& blocked : blocked_)
    if (now < blocked.until && (view_W - blocked.p_W).norm() < kBlockedNear_m) return true;
  const double apart = 2 * config_.uav.limits.radius_m + kGoalsApart_m;
  for (const FleetView::Other& other : others) {
    const double distance = (view_W - other.x_W()).norm();
    if (distance >= apart) continue;
    // Of two UAVs near a view the nearer one has it, lest both leave it to the other.
    if (other.has_goal || distance < (view_W - state_->X_WB.p).norm()) return true;
  }
  return false;
}

bool ViewPlanner::Balance(const Prospect& prospect, Utime now) {
  if (!correction_.claiming()) return false;
  std::vector<Eigen::Vector3d> elements_W;
  for (const Element& element : prospect.elements) elements_W.push_back(element.p_W);
  if (!Unbalanced(elements_W, now)) {
    correction_.Release();
    return false;
  }
  std::vector<Eigen::Vector3d> uavs_W{state_->X_WB.p};
  for (const FleetView::Other& other : prospect.others) uavs_W.push_back(other.x_W());
  const auto seed =
      static_cast<std::uint64_t>(config_.mission.seed) * 1000003u + static_cast<std::uint64_t>(now);
  SizeRule rule;
  if (config_.planner.clusters == "soft") rule.lambda_m2 = config_.planner.clusters_lambda_m2;
  const std::vector<Eigen::Vector3d> centroids_W =
      DivideWork(elements_W, uavs_W, lengths_between_, rule, seed);
  if (centroids_W.empty()) {
    correction_.Release();
    return false;
  }
  std::vector<Eigen::Vector3d> by_uav(static_cast<std::size_t>(config_.mission.uavs),
                                      FleetCorrection::Nowhere());
  by_uav[uav_ - 1] = centroids_W[0];
  for (std::size_t i = 0; i < prospect.others.size(); ++i)
    by_uav[prospect.others[i].uav - 1] = centroids_W[i + 1];
  correction_.Begin(std::move(by_uav), now);
  return true;
}

std::optional<std::size_t> ViewPlanner::Choose(const Prospect& prospect, const Start& start, Utime now,
                                               Path& path) {
  if (prospect.views.empty()) return std::nullopt;
  std::vector<Eigen::Vector3d> others_W;
  std::vector<PlanningMap::Ball> avoid;
  const double apart = 2 * config_.uav.limits.radius_m;
  for (const FleetView::Other& other : prospect.others) {
    others_W.push_back(other.x_W());
    if (!other.has_goal && (other.p_W - start.p_W).norm() > apart) avoid.push_back({other.p_W, apart});
  }
  const FleetAssignment* correction = correction_.Current(now);
  const Situation situation{map_,
                            surface_.goals(),
                            window_,
                            config_.quality.eta_m,
                            prospect.elements,
                            prospect.views,
                            uav_,
                            start.p_W,
                            start.leaves.v_W,
                            others_W,
                            correction ? &correction->centroid_W_by_uav : nullptr};
  std::vector<std::size_t> without_way;
  const std::optional<std::size_t> choice = strategy_->Choose(situation, [&](const View& view) {
    std::optional<Path> found = FindWay(start, view, avoid);
    if (found && found->ends_at_goal) {
      path = std::move(*found);
      return true;
    }
    blocked_.push_back({view.p_W, now + FromSeconds(kBlocked_s)});
    memory_.CountBlocked(map_, view.element);
    without_way.push_back(static_cast<std::size_t>(&view - prospect.views.data()));
    return false;
  });
  if (choice && hear_decision_)
    hear_decision_({decisions_ + 1, now, situation, strategy_->Scores(situation), without_way, *choice});
  return choice;
}

std::optional<Path> ViewPlanner::FindWay(const Start& start, const View& view,
                                         const std::vector<PlanningMap::Ball>& avoid) {
  std::optional<Path> way = find_path_(start.p_W, view.p_W, avoid);
  if (!way || !start.through) return way;
  std::vector<Waypoint> before = {{start.leaves.p_W, reachable_->space().FreeRadius(start.leaves.p_W)}};
  const std::optional<Path> there = find_path_(start.leaves.p_W, start.p_W, avoid);
  if (there && there->ends_at_goal) before.assign(there->waypoints.begin(), there->waypoints.end() - 1);
  way->waypoints.insert(way->waypoints.begin(), before.begin(), before.end());
  return way;
}

void ViewPlanner::Commit(const Prospect& prospect, const View& view, Path path, Utime now) {
  path.id =
      1 + std::max(path_ ? path_->id : 0, flight_.path_id);  // started again, it goes on from what is flown
  path.goal_yaw_rad = view.yaw_rad;
  path.limits = config_.uav.limits;
  double length_m = 0;
  for (std::size_t i = 1; i < path.waypoints.size(); ++i)
    length_m += (path.waypoints[i].p_W - path.waypoints[i - 1].p_W).norm();
  path_ = std::move(path);

  Goal goal;
  goal.view = view;
  goal.seen = WellSeenFrom(map_, prospect.elements, window_, view.p_W);
  goal.made_for.push_back(view.element);
  for (const std::uint32_t voxel : goal.seen)
    if ((map_.grid().Centre(map_.grid().FromLinear(voxel)) - view.element_W).norm() <= kGroup_m)
      goal.made_for.push_back(voxel);
  goal.deadline = now + FromSeconds(10 + length_m / 0.5);
  goal_ = std::move(goal);
  ++decisions_;
  correction_.CountSelection();
  no_view_left_ = false;
}

void ViewPlanner::CountStandOffs(const Prospect& prospect, Utime now) {
  for (const View& view : prospect.candidates.views) {
    const bool waits = std::any_of(blocked_.begin(), blocked_.end(), [&](const Blocked& blocked) {
      return (view.p_W - blocked.p_W).norm() < kBlockedNear_m;
    });
    const bool mate_idles =
        std::any_of(prospect.others.begin(), prospect.others.end(), [&](const FleetView::Other& other) {
          return !other.has_goal &&
                 (view.p_W - other.p_W).norm() < 2 * config_.uav.limits.radius_m + kGoalsApart_m;
        });
    if (waits || !mate_idles) continue;
    blocked_.push_back({view.p_W, now + FromSeconds(kStandOff_s)});
    memory_.CountBlocked(map_, view.element);
  }
}

void ViewPlanner::NoChoice(const Prospect& prospect, Utime now) {
  // A goal that is all but reached is flown to its end; one that has been reached, or is worthless, is over.
  const bool on_the_way = goal_ && goal_->looked_ahead && (state_->X_WB.p - goal_->view.p_W).norm() > 0.25;
  if (on_the_way) {
    goal_->finished = false;
    passing_.reset();
    return;
  }
  goal_.reset();
  passing_.reset();
  CountStandOffs(prospect, now);
  const bool none = prospect.candidates.views.empty() && prospect.views.empty() && !prospect.is_left_to_mates;
  retry_ = !none || prospect.candidates.untested > 0 || prospect.some_taken;
  const bool all_tested = none && !retry_ && looks_.empty() && now > first_map_ + FromSeconds(kWarmUp_s);
  // Before it is said that nothing is left, verdicts from before the last discovery are tested anew.
  const bool outdated = all_tested && memory_.RetestBefore(surface_.last_discovery()) > 0;
  retry_ |= outdated || !all_tested;
  no_view_left_ = none && (no_view_left_ || (all_tested && !outdated));
}

}  // namespace citrine::planner
