#include "planner/view/rated_views.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/parallel_for.h"
#include "core/trajectory/path.h"
#include "planner/view/pose_lattice.h"
#include "planner/view/view_generator.h"
#include "planner/view/well_seen.h"

namespace citrine::planner {

namespace {

constexpr double kStop_m = 1.5;  ///< of flight, that slowing down for a view is worth
constexpr double kAsGood = 0.8;
constexpr int kParts = 8;  ///< that threads take
constexpr std::size_t kViewsMax = 8;
constexpr std::uint32_t kNoElement = ~std::uint32_t{0};

/// Elements side by side count as one that is worth as many.
struct Alike {
  const Element* element;
  int worth = 0;
};

std::vector<Alike> GroupAlike(const VoxelGrid& grid, const std::vector<Element>& elements,
                              const std::vector<std::size_t>& which) {
  std::vector<Alike> groups;
  std::vector<int> group_of(elements.size(), -1);
  SharedViews shared(grid);
  for (const std::size_t i : which) {
    if (elements[i].attempts > 0) continue;
    const int leader = shared.Leader(elements, static_cast<int>(i));
    if (leader < 0) {
      shared.Lead(elements, static_cast<int>(i));
      group_of[i] = static_cast<int>(groups.size());
      groups.push_back({&elements[i], 0});
    }
    ++groups[static_cast<std::size_t>(group_of[leader < 0 ? i : static_cast<std::size_t>(leader)])].worth;
  }
  return groups;
}

struct Rated {
  double rate = 0;
  View view;
};

double Rate(double worth, const Eigen::Vector3d& view_W, const Eigen::Vector3d& p_W) {
  return worth / ((view_W - p_W).norm() + kStop_m);
}

/// A view is made for the element that comes into sight last.
View MakeView(const Eigen::Vector3d& view_W, const PlanningMap& map, const SensorWindow& window,
              const std::vector<Alike>& groups, const Eigen::Vector3d& p_W) {
  const Element* last = nullptr;
  for (const Alike& alike : groups) {
    if (!WellSeen(map, *alike.element, window, view_W)) continue;
    if (!last || (alike.element->p_W - p_W).squaredNorm() > (last->p_W - p_W).squaredNorm())
      last = alike.element;
  }
  const Eigen::Vector3d to = last->p_W - view_W;
  return {view_W, std::atan2(to.y(), to.x()), last->linear, last->p_W, View::Kind::kAround};
}

/// From how far a look should settle an element, with the tolerance of arrival to spare.
double ReachOf(const Element& element, const SensorWindow& window) {
  return std::min(element.d_star_m - kReached_m, window.range_max_m());
}

/// [m] where a pose may settle one of some elements.
Eigen::AlignedBox3d InReachOf(const std::vector<Alike>& groups, const SensorWindow& window) {
  Eigen::AlignedBox3d in_reach_W;
  for (const Alike& alike : groups) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ReachOf(*alike.element, window));
    in_reach_W.extend(Eigen::AlignedBox3d(alike.element->p_W - reach, alike.element->p_W + reach));
  }
  return in_reach_W;
}

/// Adds what poses settle of some elements to what they are worth. @return the elements that none settles
template <class Counts>
std::vector<const Element*> AddWorth(PoseLattice& lattice, const PlanningMap& map, const SensorWindow& window,
                                     const std::vector<Alike>& groups, const Counts& counts) {
  std::vector<std::uint8_t> settled(groups.size(), 0);
  ParallelForEach(groups.size(), kParts, [&](std::size_t i) {
    const Element& element = *groups[i].element;
    lattice.Within(element.p_W, ReachOf(element, window), counts,
                   [&](std::size_t pose, const Eigen::Vector3d& pose_W) {
                     if (!WellSeen(map, element, window, pose_W)) return;
                     lattice.AddWorth(pose, groups[i].worth);
                     settled[i] = 1;
                   });
  });
  std::vector<const Element*> unsettled;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (!settled[i]) unsettled.push_back(groups[i].element);
  return unsettled;
}

/// The elements outside of a patch that its poses may see.
std::vector<std::size_t> Around(const Patch& patch, const std::vector<Element>& elements,
                                const PoseLattice& lattice, const SensorWindow& window) {
  std::vector<std::size_t> around;
  const Eigen::AlignedBox3d asked_W = lattice.AskedAbout_W();
  if (asked_W.isEmpty()) return around;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double reach_m = ReachOf(elements[i], window);
    if (asked_W.squaredExteriorDistance(elements[i].p_W) <= reach_m * reach_m &&
        !std::binary_search(patch.elements.begin(), patch.elements.end(), i))
      around.push_back(i);
  }
  return around;
}

}  // namespace

std::vector<View> RatedViews(const PlanningMap& map, const SensorWindow& window,
                             const std::vector<Element>& elements, const Patch& patch,
                             const OwnViews& own_views,
                             const std::function<bool(const Eigen::Vector3d&)>& allowed,
                             const Eigen::Vector3d& p_W) {
  const std::vector<Alike> in_patch = GroupAlike(map.grid(), elements, patch.elements);
  PoseLattice lattice(map.grid(), InReachOf(in_patch, window), allowed);
  std::vector<std::size_t> by_own_view;
  for (const Element* unsettled : AddWorth(lattice, map, window, in_patch, [](std::size_t) { return true; }))
    by_own_view.push_back(static_cast<std::size_t>(unsettled - elements.data()));
  for (const std::size_t i : patch.elements)
    if (elements[i].attempts > 0) by_own_view.push_back(i);
  std::sort(by_own_view.begin(), by_own_view.end());

  std::vector<Rated> rated;
  for (const View& view : own_views(by_own_view)) rated.push_back({Rate(1, view.p_W, p_W), view});

  const std::vector<Alike> nearby =
      GroupAlike(map.grid(), elements, Around(patch, elements, lattice, window));
  AddWorth(lattice, map, window, nearby, [&](std::size_t pose) { return lattice.worth(pose) > 0; });
  for (const std::size_t pose : lattice.WithWorth()) {
    const Eigen::Vector3d pose_W = lattice.At(pose);
    rated.push_back({Rate(lattice.worth(pose), pose_W, p_W), {.p_W = pose_W, .element = kNoElement}});
  }

  std::stable_sort(rated.begin(), rated.end(),
                   [](const Rated& a, const Rated& b) { return a.rate > b.rate; });
  std::vector<View> views;
  for (const Rated& r : rated) {
    if (views.size() == kViewsMax || r.rate < kAsGood * rated.front().rate) break;
    views.push_back(r.view.element == kNoElement ? MakeView(r.view.p_W, map, window, in_patch, p_W) : r.view);
  }
  return views;
}

}  // namespace citrine::planner
