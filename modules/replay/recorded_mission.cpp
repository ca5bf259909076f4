#include "modules/replay/recorded_mission.h"

#include <algorithm>
#include <stdexcept>

#include "core/config/config_file.h"
#include "modules/codec/bad_message.h"
#include "modules/every_channel.h"

namespace citrine {
namespace {

MissionConfigText FindConfig(const std::vector<LogEvent>& events, const std::string& log_path) {
  for (const LogEvent& event : events) {
    citrine_lcm::mission_config_t message{};
    if (event.channel != channels::kMissionConfig.name) continue;
    try {
      Require(message.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size())) > 0, "cut short");
      return Decode(message);
    } catch (const std::exception&) {  // it is said again
    }
  }
  throw std::runtime_error(log_path + ": holds no MISSION_CONFIG, so nobody knows what was flown");
}

}  // namespace

RecordedMission ReadMission(const std::string& log_path) {
  RecordedMission mission;
  mission.events = ReadInOrder(log_path, &mission.flaws);
  mission.flown = FindConfig(mission.events, log_path);
  mission.config = ParseMission(mission.flown.toml, mission.flown.overrides);
  return mission;
}

}  // namespace citrine
