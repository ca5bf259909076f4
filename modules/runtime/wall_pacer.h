#pragma once

#include <algorithm>
#include <chrono>

namespace citrine {

/// Paces mission time against the wall; the owner of time alone uses it.
class WallPacer {
 public:
  /// @param pace mission seconds a second of the wall; 0: never waits
  WallPacer(double pace, double step_s) : step_(pace > 0 ? Seconds(step_s / pace) : Seconds(0)) {}

  /// The step under way ends now; a host that is too slow does not catch up on more than a moment.
  void EndStep() {
    end_ += std::chrono::duration_cast<Clock::duration>(step_);
    end_ = std::max(end_, Clock::now() - kCatchUp);
  }
  /// [ms] to wait until the next step is due, at least 0.
  double left_ms() const {
    const std::chrono::duration<double, std::milli> left = end_ - Clock::now();
    return step_.count() > 0 ? std::max(0.0, left.count()) : 0.0;
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  static constexpr std::chrono::milliseconds kCatchUp{200};

  Seconds step_;
  Clock::time_point end_ = Clock::now();
};

}  // namespace citrine
