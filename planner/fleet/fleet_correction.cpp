#include "planner/fleet/fleet_correction.h"

#include <algorithm>
#include <cstdlib>

namespace citrine::planner {

namespace {

Utime Begun(const FleetAssignment& assignment) { return assignment.plan_id / 16; }

/// Whether a mate is done with an assignment; one that never heard of it is not.
bool Done(const TeamMate& mate, std::int64_t plan_id) {
  return mate.plan_id == plan_id ? mate.selections_left == 0 : mate.plan_id > plan_id;
}

}  // namespace

bool FleetCorrection::Supersedes(const FleetAssignment& a, const FleetAssignment& b) {
  const Utime apart = Begun(a) - Begun(b);
  if (std::llabs(apart) <= FromSeconds(kTogether_s)) return a.sender < b.sender;
  return apart > 0;
}

void FleetCorrection::Update(const std::vector<TeamMate>& mates, Utime now) {
  if (known_ && now >= known_->expiry) left_ = 0;
  if (claiming_)
    for (const TeamMate& mate : mates)
      if (mate.alive && mate.replanning && mate.uav < uav_) claiming_ = false;
  if (!holding_) return;
  const bool all_done = left_ == 0 && std::all_of(mates.begin(), mates.end(), [&](const TeamMate& mate) {
                          return !mate.alive || Done(mate, known_->plan_id);
                        });
  if (all_done || now >= known_->expiry) holding_ = false;
}

bool FleetCorrection::MayBegin(const std::vector<TeamMate>& mates, Utime now) const {
  if (replanning() || left_ > 0) return false;
  const bool pending = known_ && now < known_->expiry;
  return std::none_of(mates.begin(), mates.end(), [&](const TeamMate& mate) {
    return mate.alive && (mate.replanning || (pending && !Done(mate, known_->plan_id)));
  });
}

FleetAssignment FleetCorrection::Begin(std::vector<Eigen::Vector3d> centroid_W_by_uav, Utime now) {
  known_ = FleetAssignment{now * 16 + uav_, uav_, now + FromSeconds(expiry_s_), selections_,
                           std::move(centroid_W_by_uav)};
  left_ = selections_;
  claiming_ = false;
  holding_ = true;
  return *known_;
}

bool FleetCorrection::Hear(const FleetAssignment& assignment, Utime now) {
  if (assignment.sender == uav_ || now >= assignment.expiry) return false;
  if (known_ && (assignment.plan_id == known_->plan_id || !Supersedes(assignment, *known_))) return false;
  known_ = assignment;
  left_ = assignment.selections;
  claiming_ = holding_ = false;
  return true;
}

const FleetAssignment* FleetCorrection::Current(Utime now) const {
  return known_ && left_ > 0 && now < known_->expiry ? &*known_ : nullptr;
}

const FleetAssignment* FleetCorrection::OwnToRepeat(Utime now) const {
  return known_ && known_->sender == uav_ && holding_ && now < known_->expiry ? &*known_ : nullptr;
}

}  // namespace citrine::planner
