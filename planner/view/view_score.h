#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "planner/view/information_gain.h"
#include "planner/view/partial_gain.h"

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
/// Exact: J_I is bounded by the elements in range and field of view, first for all views of a cube of space
/// at once, and the view with the highest bound is looked into further until it is known to the end and no
/// other can win. The normalising max |ASE_v| of eq. (8) is only known to lie between a count and a bound; J
/// is linear in its inverse, so a view that is ahead of another at both ends is ahead in between, and the two
/// are brought together only until one view is ahead at both. Equal scores: the first in the list.
class BestView {
 public:
  BestView(const InformationGain& gain, std::vector<ViewTerms> views, const ScoreWeights& weights);

  /// The best view that has not been discarded. nullopt: none is left
  std::optional<std::size_t> Next();
  /// Takes a view out; the normalisation stays that of the whole list.
  void Discard(std::size_t view) { discarded_[view] = true; }

  /// What J of a view is made of, whether it is the best or not.
  Score ScoreOf(std::size_t view);
  /// max |ASE_v| of eq. (8), which Next() can do without.
  int MostVisible();
  /// Views whose gain is known to the end so far.
  int evaluated() const;

 private:
  struct Leader {
    std::size_t view;
    bool clearly;  ///< ahead by more than rounding can change, or of views that are alike
  };
  struct Interval {
    int least, most;
  };
  Interval MostVisibleBounds() const;
  /// Brings the bounds on max |ASE_v| together by a little.
  void CountFurther();
  /// Begins with a view in each cube of space, as what sees most need not be what is bounded by most.
  void LookEverywhere();
  /// The best view if max |ASE_v| were so much, of those that reach a total with J_I = 1. It may be any, and
  /// is not clearly ahead, if a view turns out to see more. nullopt: none is left
  std::optional<Leader> LeaderIf(int most_visible, double floor);
  double Total(std::size_t view, int most_visible) const;
  double Rest(std::size_t view) const;  ///< J without J_I
  bool Alike(std::size_t a, std::size_t b) const;

  const InformationGain& gain_;
  std::vector<ViewTerms> views_;
  ScoreWeights weights_;
  std::vector<PartialGain> gain_of_;
  std::vector<std::size_t> one_of_each_cube_;
  Suspicion suspicion_;
  std::vector<bool> discarded_;
};

}  // namespace citrine::planner
