#include "planner/view/shortlist.h"

#include <algorithm>
#include <limits>

#include "planner/view/groups.h"

namespace citrine::planner {

namespace {

constexpr double kAsNear = 1.5;  ///< times the distance of the nearest: as good as equally near

/// Keeps the views of the nearest small groups, if they are near or there are no others.
bool KeepLeftovers(std::vector<View>& views, const std::vector<Element>& elements, const Eigen::Vector3d& p_W,
                   const ShortlistRules& rules) {
  const std::vector<int> group = GroupSizes(elements);
  const auto leftover = [&](const View& view) {
    const auto element =
        std::lower_bound(elements.begin(), elements.end(), view.element,
                         [](const Element& e, std::uint32_t linear) { return e.linear < linear; });
    return group[element - elements.begin()] <= rules.leftover_elements;
  };
  double nearest_m = std::numeric_limits<double>::infinity();
  bool nothing_else = true;
  for (const View& view : views) {
    if (leftover(view))
      nearest_m = std::min(nearest_m, (view.p_W - p_W).norm());
    else
      nothing_else = false;
  }
  if (nearest_m > rules.tidy_m && !nothing_else) return false;
  const double reach_m = std::max(rules.hop_min_m, kAsNear * nearest_m);
  std::erase_if(views,
                [&](const View& view) { return !leftover(view) || (view.p_W - p_W).norm() > reach_m; });
  return true;
}

void LeaveNearOnes(std::vector<View>& views, const Eigen::Vector3d& p_W, double hop_m) {
  const auto distance_m = [&](const View& view) { return (view.p_W - p_W).norm(); };
  const bool goes_on = std::any_of(views.begin(), views.end(), [&](const View& view) {
    return distance_m(view) >= hop_m && distance_m(view) <= 2 * hop_m;
  });
  if (goes_on) std::erase_if(views, [&](const View& view) { return distance_m(view) < hop_m; });
}

}  // namespace

void Shorten(std::vector<View>& views, const std::vector<Element>& elements, const Eigen::Vector3d& p_W,
             const ShortlistRules& rules) {
  if (views.empty()) return;
  if (rules.tidy_m > 0 && KeepLeftovers(views, elements, p_W, rules)) return;
  LeaveNearOnes(views, p_W, rules.hop_min_m);
}

}  // namespace citrine::planner
