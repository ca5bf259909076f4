#pragma once

#include <string>

namespace citrine {

/// What the user of `replay` asks for.
struct ReplayOptions {
  std::string log;   ///< or a result folder
  std::string into;  ///< a kind of module; empty: onto the bus
  double speed =
      0;  ///< mission seconds a second of the wall; 0: 1 on the bus, as fast as it goes into a module
  std::string out;                   ///< where topdown_renderer writes; empty: nowhere that stays
  bool view = false, video = false;  ///< of topdown_renderer
};

/// THE LIST of modules that a recording can be fed into.
inline constexpr const char* kReplayable[] = {"map_fusion", "view_planner", "trajectory_smoother",
                                              "topdown_renderer"};

}  // namespace citrine
