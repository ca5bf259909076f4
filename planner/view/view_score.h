#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "planner/view/information_gain.h"

namespace citrine::planner {

/// Weights of eq. (6).
struct ScoreWeights {
  double alpha = 1, beta = 1, gamma = 2;
};

/// The parts of one view's score that need no map.
struct ViewTerms {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  double navigation = 0;    ///< J_N
  double coordination = 0;  ///< J_C
};

/// A view's score and what it is made of, for those who ask why.
struct Score {
  double total = 0, information = 0, navigation = 0, coordination = 0;
};

/// Finds the view with the largest J = alpha J_I + beta J_N + gamma J_C (eq. 6) without evaluating all of
/// them.
///
/// Exact: J_I is bounded by the elements in range and field of view, and views are evaluated in the order of
/// their bound until none can win; so is the normalising max |ASE_v| of eq. (8). Equal scores: the first in
/// the list.
class BestView {
 public:
  BestView(const InformationGain& gain, std::vector<ViewTerms> views, const ScoreWeights& weights);

  /// The best view that has not been discarded. nullopt: none is left
  std::optional<std::size_t> Next();
  /// Takes a view out; the normalisation stays that of the whole list.
  void Discard(std::size_t view) { discarded_[view] = true; }

  /// Score of a view that Next() has returned.
  Score ScoreOf(std::size_t view) const;
  int most_visible() const { return most_visible_; }
  int evaluated() const { return evaluated_; }

 private:
  void FindMostVisible();
  double Total(std::size_t view, double gain_sum) const;

  const InformationGain& gain_;
  std::vector<ViewTerms> views_;
  ScoreWeights weights_;
  std::vector<GainBound> bound_;
  std::vector<Gain> exact_;
  std::vector<bool> known_, discarded_;
  int most_visible_ = 0, evaluated_ = 0;
};

}  // namespace citrine::planner
