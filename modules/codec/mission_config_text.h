#pragma once

#include <string>
#include <vector>

#include <citrine_lcm/mission_config_t.hpp>

namespace citrine {

/// What is flown, as text: enough to fly it again.
struct MissionConfigText {
  std::string mission_id;
  std::string toml;                    ///< the mission file
  std::vector<std::string> overrides;  ///< "section.key=value", later ones win
  std::string commit;
  bool dirty = false;  ///< the working tree differed from the commit
};

citrine_lcm::mission_config_t Encode(const MissionConfigText& text);

/// @throws BadMessage without a mission id
MissionConfigText Decode(const citrine_lcm::mission_config_t& message);

}  // namespace citrine
