#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "modules/replay/recorded_mission.h"
#include "viz/image.h"

namespace citrine {

/// A recorded decision, made again and told.
struct Explanation {
  std::string text;  ///< candidates, what their scores are made of, who won and why
  viz::Image picture;
  std::int64_t decisions = 0;  ///< selections of this UAV until then
  bool found = false;          ///< else the recording has fewer, and there is neither text nor picture
  bool as_recorded = false;    ///< whether the recording flew to the same view
};

/// Feeds a recording into the real planner of one UAV until it selects a view for the `number`-th time (from
/// 1).
/// @param rows  candidates listed at most  @param interrupted asked once a step
/// @throws what the planner's constructor throws
Explanation Explain(const RecordedMission& mission, int uav, std::int64_t number, int rows,
                    const std::function<bool()>& interrupted = nullptr);

}  // namespace citrine
