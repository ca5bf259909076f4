#pragma once

#include "planner/strategy/strategy.h"
#include "planner/view/view_score.h"

namespace citrine::planner {

/// The paper's decision (IV-B, IV-C): the view with the largest alpha J_I + beta J_N + gamma J_C; under an
/// imbalance correction J_C is 0 for views of elements outside the UAV's own Voronoi cell (eq. 16).
class QualityAdaptive : public Strategy {
 public:
  explicit QualityAdaptive(const ScoreWeights& weights) : weights_(weights) {}
  std::optional<std::size_t> Choose(const Situation& situation, const Accept& accept) override;
  std::vector<Score> Scores(const Situation& situation) const override;

 private:
  ScoreWeights weights_;
};

}  // namespace citrine::planner
