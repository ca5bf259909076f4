#pragma once

#include <cstdint>

#include "core/time.h"

namespace citrine {

/// One tick of mission time. In lockstep a module sees, at step k, exactly what was said in steps before k.
struct Step {
  std::int64_t index = 0;
  Utime now = 0;      ///< index x dynamics.step_s
  bool last = false;  ///< the mission is over: write what is to be written
};

}  // namespace citrine
