#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/fleet/fleet_status.h"
#include "core/time.h"

namespace citrine::planner {

/// What the protocol needs to know of another UAV.
struct TeamMate {
  int uav = 0;
  bool alive = false;  ///< spoke within 3 s
  bool replanning = false;
  std::int64_t plan_id = 0;
  int selections_left = 0;
};

// clang-format off
/// One UAV's side of the imbalance correction (paper, IV-C): who may begin one, which one holds, when it is over.
///
///   state    | what happens                                    | next     | said
///   ---------+-------------------------------------------------+----------+------------------------------------------
///   resting  | imbalance at a trigger, MayBegin()              | claiming | FLEET_STATUS replanning = true
///   claiming | a living mate of lower id claims too            | resting  | replanning = false
///   claiming | an assignment of another arrives                | resting* | replanning = false
///   claiming | the decision is due, still out of balance       | holding* | FLEET_ASSIGNMENT, replanning stays true
///   claiming | the decision is due, balance has returned       | resting  | replanning = false
///   holding  | every living mate has made its k selections     | resting  | replanning = false
///   holding  | the assignment expired (20 s)                   | resting  | replanning = false
///   holding  | an assignment that holds against its own arrives| resting* | replanning = false
///
/// (*) and the assignment is followed for k selections or until it expires, in any state. Nobody begins while a living
/// mate claims or holds, or while an assignment that it knows is not resolved. Of two assignments begun within 1 s the
/// one of the lower id holds, else the newer: so all agree in whatever order they arrive. A mate silent for 3 s is
/// planned without, and waits for nobody.
// clang-format on
class FleetCorrection {
 public:
  static constexpr double kSilence_s = 3.0;
  static constexpr double kTogether_s = 1.0;
  /// Where the centroid of a UAV that is planned without lies: nothing is nearest to it.
  static Eigen::Vector3d Nowhere() { return Eigen::Vector3d::Constant(1e6); }

  FleetCorrection(int uav, int selections, double expiry_s)
      : uav_(uav), selections_(selections), expiry_s_(expiry_s) {}

  /// Follows mates and time; releases what is over or has to yield.
  void Update(const std::vector<TeamMate>& mates, Utime now);

  /// Whether this UAV may claim the right to balance the fleet.
  bool MayBegin(const std::vector<TeamMate>& mates, Utime now) const;
  void Claim() { claiming_ = true; }
  void Release() { claiming_ = holding_ = false; }
  bool claiming() const { return claiming_; }

  /// Turns the claim into an assignment, which this UAV itself follows from now on.
  FleetAssignment Begin(std::vector<Eigen::Vector3d> centroid_W_by_uav, Utime now);

  /// Takes an assignment over if it holds against the one known. @return whether it did
  bool Hear(const FleetAssignment& assignment, Utime now);

  /// The assignment that restricts the next selection. nullptr: none
  const FleetAssignment* Current(Utime now) const;
  /// To be said again until it is over: this UAV's own assignment. nullptr: none
  const FleetAssignment* OwnToRepeat(Utime now) const;
  void CountSelection() { left_ = std::max(0, left_ - 1); }

  bool replanning() const { return claiming_ || holding_; }
  std::int64_t plan_id() const { return known_ ? known_->plan_id : 0; }
  int selections_left() const { return left_; }

 private:
  static bool Supersedes(const FleetAssignment& a, const FleetAssignment& b);

  int uav_, selections_;
  double expiry_s_;
  bool claiming_ = false, holding_ = false;
  std::optional<FleetAssignment> known_;
  int left_ = 0;
};

}  // namespace citrine::planner
