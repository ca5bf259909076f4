#pragma once

#include "modules/channels.h"

namespace citrine {

/// What somebody who looks on hears of a fleet, scans and the map aside.
struct FleetInboxes {
  explicit FleetInboxes(Bus& bus)
      : states(bus.HearAll(channels::kUavState)),
        paths(bus.HearAll(channels::kPath)),
        trajectories(bus.HearAll(channels::kTrajectory)),
        statuses(bus.HearAll(channels::kFleetStatus)),
        assignments(bus.Hear(channels::kFleetAssignment)),
        progress(bus.Hear(channels::kMissionProgress)) {}

  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states;
  std::shared_ptr<Inbox<citrine_lcm::path_t>> paths;
  std::shared_ptr<Inbox<citrine_lcm::trajectory_t>> trajectories;
  std::shared_ptr<Inbox<citrine_lcm::fleet_status_t>> statuses;
  std::shared_ptr<Inbox<citrine_lcm::fleet_assignment_t>> assignments;
  std::shared_ptr<Inbox<citrine_lcm::mission_progress_t>> progress;
};

}  // namespace citrine
