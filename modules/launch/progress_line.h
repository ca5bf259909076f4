#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "modules/launch/mission_view.h"
#include "modules/launch/stall_watch.h"

namespace citrine {

/// One line of text on how a mission goes, such as
/// "t 02:14  6.1x  at goal 78.4%  known 61%  Z 0.031/0.049  ASE 1240 | 1: 3.2 m/s 61 m | ...".
std::string ProgressText(const MissionView& view, double real_time_factor);

/// Says how a mission goes: on a terminal one line that is redrawn at most 10 times a second, elsewhere a
/// line every 5 s; and, in a line of its own, that it gets no further.
class ProgressLine {
 public:
  explicit ProgressLine(std::FILE* out);

  /// To be called as often as one likes.
  void Show(const MissionView& view);

  /// Leaves the newest line standing; what is written next begins a line of its own.
  void Finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::FILE* out_;
  bool terminal_;
  bool line_open_ = false;
  StallWatch stall_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace citrine
