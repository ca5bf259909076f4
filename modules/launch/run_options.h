#pragma once

#include <string>
#include <vector>

namespace citrine {

/// What the user of `run` asks for. What has a key in the mission file is in `overrides`, in the order in
/// which it applies.
struct RunOptions {
  std::string mission;                 ///< a name in missions/ or a file
  std::vector<std::string> overrides;  ///< section.key=value
  std::string world;                   ///< of --world; empty: the mission's own
  std::string map;                     ///< of --map: result folder or saved map to go on from; empty: none
  bool isolate = false;
  bool by_hand = false;  ///< the modules are started by somebody else
};

}  // namespace citrine
