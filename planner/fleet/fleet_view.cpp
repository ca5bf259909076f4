#include "planner/fleet/fleet_view.h"

#include "core/trajectory/path.h"

namespace citrine::planner {

namespace {
constexpr std::size_t kAheadMax = 2;  ///< the view that is passed, and the one after it
}  // namespace

void FleetView::Hear(int uav, const UavState& state, Utime now) {
  if (uav < 1 || uav > uavs()) return;
  Heard& heard = heard_[uav - 1];
  heard.has_state = true;
  heard.state_at = now;
  heard.p_W = state.X_WB.p;
  for (std::size_t i = heard.ahead_W.size(); i-- > 0;) {
    if ((heard.ahead_W[i] - heard.p_W).norm() > kReached_m) continue;
    looks_W_.push_back(heard.ahead_W[i]);
    heard.ahead_W.erase(heard.ahead_W.begin(), heard.ahead_W.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    break;
  }
}

void FleetView::Hear(int uav, const FleetStatus& status, Utime now) {
  if (uav < 1 || uav > uavs()) return;
  Heard& heard = heard_[uav - 1];
  heard.has_status = true;
  heard.status_at = now;
  heard.status = status;
  if (!heard.has_state) heard.p_W = status.X_WB.p;
  if (!status.has_goal || (!heard.ahead_W.empty() && heard.ahead_W.back() == status.goal_W)) return;
  heard.ahead_W.push_back(status.goal_W);
  if (heard.ahead_W.size() > kAheadMax) heard.ahead_W.erase(heard.ahead_W.begin());
}

bool FleetView::AliveAt(const Heard& heard, Utime now) const {
  const Utime silence = FromSeconds(FleetCorrection::kSilence_s);
  if (heard.has_status) return now - heard.status_at < silence;
  return heard.has_state && now < silence;  // at the beginning nobody has spoken yet
}

std::vector<FleetView::Other> FleetView::Alive(Utime now) const {
  std::vector<Other> others;
  for (int uav = 1; uav <= uavs(); ++uav) {
    const Heard& heard = heard_[uav - 1];
    if (uav == uav_ || !AliveAt(heard, now)) continue;
    others.push_back({uav, heard.p_W, heard.status.has_goal, heard.status.goal_W,
                      heard.status.activity == FleetStatus::Activity::kDeciding,
                      heard.status.deciding_since});
  }
  return others;
}

std::vector<TeamMate> FleetView::Mates(Utime now) const {
  std::vector<TeamMate> mates;
  for (int uav = 1; uav <= uavs(); ++uav) {
    const Heard& heard = heard_[uav - 1];
    if (uav == uav_) continue;
    mates.push_back({uav, AliveAt(heard, now), heard.status.replanning, heard.status.plan_id,
                     heard.status.corrected_selections_left});
  }
  return mates;
}

}  // namespace citrine::planner
