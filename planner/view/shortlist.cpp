#include "planner/view/shortlist.h"

#include <algorithm>

namespace citrine::planner {

void LeaveNearOnes(std::vector<View>& views, const Eigen::Vector3d& p_W, double hop_m) {
  const auto distance_m = [&](const View& view) { return (view.p_W - p_W).norm(); };
  const bool goes_on = std::any_of(views.begin(), views.end(), [&](const View& view) {
    return distance_m(view) >= hop_m && distance_m(view) <= 2 * hop_m;
  });
  if (goes_on) std::erase_if(views, [&](const View& view) { return distance_m(view) < hop_m; });
}

}  // namespace citrine::planner
