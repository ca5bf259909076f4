#pragma once

#include <optional>
#include <string>

#include "modules/launch/mission_view.h"

namespace citrine {

/// Notices that a mission gets no further: for a minute of its time no surface has been found and none has
/// newly reached its goal, though active elements are left.
class StallWatch {
 public:
  /// @return what to say, once a stall
  std::optional<std::string> Look(const MissionView& view);

 private:
  std::int32_t most_surface_ = -1, most_at_goal_ = -1;
  Utime since_ = 0;
  bool told_ = false;
};

}  // namespace citrine
