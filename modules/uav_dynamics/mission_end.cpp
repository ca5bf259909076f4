#include "modules/uav_dynamics/mission_end.h"

#include <algorithm>

namespace citrine {

MissionEnd::MissionEnd(int uavs, double time_limit_s)
    : time_limit_(FromSeconds(time_limit_s)), verdicts_(static_cast<std::size_t>(uavs)) {}

void MissionEnd::Hear(int uav, const FleetStatus& status) {
  if (uav < 1 || uav > static_cast<int>(verdicts_.size())) return;
  verdicts_[static_cast<std::size_t>(uav - 1)] = {status.no_view_left, status.map_version};
  if (!status.no_view_left) quiet_since_.reset();
}

void MissionEnd::HearMapVersion(std::int64_t map_version) { map_version_ = std::max(map_version_, map_version); }

std::optional<std::string> MissionEnd::At(Utime now) {
  if (AllSayNoViewLeft()) {
    if (!quiet_since_) {
      quiet_since_ = now;
      version_to_agree_on_ = map_version_;
      for (const Verdict& verdict : verdicts_) version_to_agree_on_ = std::max(version_to_agree_on_, verdict.map_version);
    }
    if (now - *quiet_since_ >= FromSeconds(kQuiet_s) && OldestVersion() >= version_to_agree_on_) return "surface_complete";
  }
  if (now >= time_limit_) return "time_limit";
  return std::nullopt;
}

bool MissionEnd::AllSayNoViewLeft() const {
  return std::all_of(verdicts_.begin(), verdicts_.end(), [](const Verdict& verdict) { return verdict.no_view_left; });
}

std::int64_t MissionEnd::OldestVersion() const {
  const auto older = [](const Verdict& a, const Verdict& b) { return a.map_version < b.map_version; };
  return std::min_element(verdicts_.begin(), verdicts_.end(), older)->map_version;
}

}  // namespace citrine
