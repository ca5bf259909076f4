#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/time.h"
#include "planner/strategy/strategy.h"
#include "planner/view/view_score.h"

namespace citrine::planner {

/// One selection of a view, for those who ask why. Its parts live while it is told only.
struct Decision {
  std::int64_t number;  ///< of this UAV's selections, from 1
  Utime at;
  const Situation& situation;
  const std::vector<Score>& scores;             ///< one a view of the situation
  const std::vector<std::size_t>& without_way;  ///< views that scored higher, but no way leads to them
  std::size_t chosen;
};

using HearDecision = std::function<void(const Decision&)>;

}  // namespace citrine::planner
