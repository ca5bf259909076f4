#pragma once

#include <string>

namespace citrine {

/// What lcm-spy needs on this machine.
struct SpyParts {
  std::string jar;      ///< of the message types and the mission from above
  std::string missing;  ///< what there is not, and the command that brings it; empty if it can start
  std::string stale;    ///< which types are newer than the jar; empty if none
};
SpyParts FindSpyParts();

}  // namespace citrine
