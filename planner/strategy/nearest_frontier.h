#pragma once

#include "planner/strategy/strategy.h"

namespace citrine::planner {

/// The plainest decision there is: the nearest view (Yamauchi 1997). What every other strategy has to beat.
class NearestFrontier : public Strategy {
 public:
  std::optional<std::size_t> Choose(const Situation& situation, const Accept& accept) override;
  std::vector<Score> Scores(const Situation& situation) const override;
};

}  // namespace citrine::planner
