#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/fleet/fleet_status.h"
#include "core/vehicle/uav_state.h"
#include "planner/fleet/fleet_correction.h"

namespace citrine::planner {

/// The rest of the fleet as one UAV hears it.
class FleetView {
 public:
  struct Other {
    int uav = 0;
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
    bool has_goal = false;
    Eigen::Vector3d goal_W = Eigen::Vector3d::Zero();
    bool deciding = false;
    Utime deciding_since = 0;
    /// Where it counts: at its goal, else at its position (design, section 6).
    const Eigen::Vector3d& x_W() const { return has_goal ? goal_W : p_W; }
  };

  FleetView(int uav, int uavs) : uav_(uav), heard_(static_cast<std::size_t>(uavs)) {}

  void Hear(int uav, const UavState& state, Utime now);
  void Hear(int uav, const FleetStatus& status, Utime now);

  /// The other UAVs that spoke within 3 s, in order of id; where one has not said a status its state stands
  /// in.
  std::vector<Other> Alive(Utime now) const;
  /// All others, for the correction's protocol.
  std::vector<TeamMate> Mates(Utime now) const;
  /// Views that mates have said to fly to and have reached since this was last asked, in order of arrival.
  /// [m]
  std::vector<Eigen::Vector3d> TakeLooks() { return std::exchange(looks_W_, {}); }
  int uavs() const { return static_cast<int>(heard_.size()); }

 private:
  struct Heard {
    bool has_state = false, has_status = false;
    Utime state_at = 0, status_at = 0;
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    FleetStatus status;
    std::vector<Eigen::Vector3d> ahead_W;  ///< goals said and not yet reached; the newest last
  };
  bool AliveAt(const Heard& heard, Utime now) const;

  int uav_;
  std::vector<Heard> heard_;
  std::vector<Eigen::Vector3d> looks_W_;
};

}  // namespace citrine::planner
