#include "modules/codec/mission_config_text.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::mission_config_t Encode(const MissionConfigText& text) {
  citrine_lcm::mission_config_t message{};
  message.dirty = text.dirty;
  message.mission_id = text.mission_id;
  message.commit = text.commit;
  message.num_overrides = static_cast<std::int32_t>(text.overrides.size());
  message.overrides = text.overrides;
  message.toml = text.toml;
  return message;
}

MissionConfigText Decode(const citrine_lcm::mission_config_t& message) {
  Require(!message.mission_id.empty(), "mission_config_t: no mission_id");
  return {message.mission_id, message.toml, message.overrides, message.commit, message.dirty != 0};
}

}  // namespace citrine
