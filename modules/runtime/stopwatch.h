#pragma once

#include <chrono>

namespace citrine {

/// Time of the wall: for waiting and pacing, never for a decision of the mission.
class Stopwatch {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace citrine
