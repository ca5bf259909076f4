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

void MissionEnd::HearMap(std::int64_t map_version, std::uint64_t digest) {
  if (map_version < map_version_) return;
  if (digest != map_digest_) map_since_ = map_version;
  map_version_ = map_version;
  map_digest_ = digest;
}

std::optional<std::string> MissionEnd::At(Utime now) {
  if (AllSayNoViewLeft()) {
    if (!quiet_since_) {
      quiet_since_ = now;
      version_to_agree_on_ = NewestMap();
    }
    if (now - *quiet_since_ >= FromSeconds(kQuiet_s) && OldestVersion() >= version_to_agree_on_)
      return "surface_complete";
  }
  if (now >= time_limit_) return "time_limit";
  return std::nullopt;
}

bool MissionEnd::AllSayNoViewLeft() const {
  return std::all_of(verdicts_.begin(), verdicts_.end(),
                     [](const Verdict& verdict) { return verdict.no_view_left; });
}

std::int64_t MissionEnd::NewestMap() const {
  std::int64_t newest = map_since_;
  for (const Verdict& verdict : verdicts_) newest = std::max(newest, FirstLike(verdict.map_version));
  return newest;
}

std::int64_t MissionEnd::FirstLike(std::int64_t map_version) const {
  return map_version <= map_version_ ? std::min(map_version, map_since_) : map_version;
}

std::int64_t MissionEnd::OldestVersion() const {
  const auto older = [](const Verdict& a, const Verdict& b) { return a.map_version < b.map_version; };
  return std::min_element(verdicts_.begin(), verdicts_.end(), older)->map_version;
}

}  // namespace citrine
