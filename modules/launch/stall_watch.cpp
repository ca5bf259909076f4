#include "modules/launch/stall_watch.h"

#include <algorithm>

namespace citrine {
namespace {

constexpr double kPatience_s = 60;

/// Of what is left, the most that any UAV has found unreachable or has given up.
template <class Count>
int MostOf(const std::vector<MissionView::Uav>& uavs, Count MissionView::Uav::*count) {
  int most = 0;
  for (const MissionView::Uav& uav : uavs) most = std::max(most, static_cast<int>(uav.*count));
  return most;
}

}  // namespace

std::optional<std::string> StallWatch::Look(const MissionView& view) {
  if (!view.clock || view.done()) return std::nullopt;
  const MissionProgress& progress = view.progress;
  const Utime now = view.clock->utime;
  if (progress.surface_voxels > most_surface_ || progress.voxels_at_goal > most_at_goal_ || now < since_) {
    most_surface_ = std::max(most_surface_, progress.surface_voxels);
    most_at_goal_ = std::max(most_at_goal_, progress.voxels_at_goal);
    since_ = now;
    told_ = false;
  }
  const int left = progress.elements_ise + progress.elements_lqse;
  if (told_ || left == 0 || Seconds(now - since_) < kPatience_s) return std::nullopt;
  told_ = true;
  return "no new surface for 60 s: " + std::to_string(left) + " active elements are left (" +
         std::to_string(MostOf(view.uavs, &MissionView::Uav::elements_unreachable)) + " unreachable, " +
         std::to_string(MostOf(view.uavs, &MissionView::Uav::elements_given_up)) +
         " given up); the mission ends when no UAV finds a view, at its time limit, or with Ctrl-C";
}

}  // namespace citrine
