#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/fleet/fleet_status.h"
#include "core/time.h"

namespace citrine {

/// When a mission ends (design, section 4): every planner says `no_view_left`, has gone on saying so for
/// kQuiet_s, and says it of the map as it was when the last of them joined in, or of a later one; or the time
/// limit is reached. Versions with the same digest are the same map: where nothing new is seen, nobody has to
/// look again.
class MissionEnd {
 public:
  static constexpr double kQuiet_s = 2.0;

  MissionEnd(int uavs, double time_limit_s);

  /// What a planner said; `uav` 1..N.
  void Hear(int uav, const FleetStatus& status);
  /// What the base station said of its map.
  void HearMap(std::int64_t map_version, std::uint64_t digest);

  /// Called once a step, with time going forward. @return "surface_complete", "time_limit", or nothing while
  /// it goes on
  std::optional<std::string> At(Utime now);

 private:
  struct Verdict {
    bool no_view_left = false;
    std::int64_t map_version = -1;
  };

  bool AllSayNoViewLeft() const;
  std::int64_t NewestMap() const;
  std::int64_t OldestVersion() const;
  /// The first version that is known to be the same map.
  std::int64_t FirstLike(std::int64_t map_version) const;

  Utime time_limit_;
  std::vector<Verdict> verdicts_;                 ///< by UAV id - 1
  std::int64_t map_version_ = 0, map_since_ = 0;  ///< newest version heard, and the first with its digest
  std::uint64_t map_digest_ = 0;
  std::optional<Utime> quiet_since_;
  std::int64_t version_to_agree_on_ = 0;
};

}  // namespace citrine
