#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/fleet/fleet_status.h"
#include "core/time.h"

namespace citrine {

/// When a mission ends (design, section 4): every planner says `no_view_left`, has gone on saying so for kQuiet_s, and
/// says it of the map as it was when the last of them joined in, or of a later one; or the time limit is reached.
class MissionEnd {
 public:
  static constexpr double kQuiet_s = 2.0;

  MissionEnd(int uavs, double time_limit_s);

  /// What a planner said; `uav` 1..N.
  void Hear(int uav, const FleetStatus& status);
  /// The base station's newest map version.
  void HearMapVersion(std::int64_t map_version);

  /// Called once a step, with time going forward. @return "surface_complete", "time_limit", or nothing while it goes on
  std::optional<std::string> At(Utime now);

 private:
  struct Verdict {
    bool no_view_left = false;
    std::int64_t map_version = -1;
  };

  bool AllSayNoViewLeft() const;
  std::int64_t OldestVersion() const;

  Utime time_limit_;
  std::vector<Verdict> verdicts_;          ///< by UAV id - 1
  std::int64_t map_version_ = 0;
  std::optional<Utime> quiet_since_;
  std::int64_t version_to_agree_on_ = 0;
};

}  // namespace citrine
