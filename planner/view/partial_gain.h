#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "planner/view/information_gain.h"

namespace citrine::planner {

/// From which of 24 sectors of directions each element was last found out of sight, one bit each: where to
/// look first for what rules a view out. Changes no result.
using Suspicion = std::vector<std::uint32_t>;

/// One view's gain as far as it has been looked into: bounds that meet once it has been to the end.
class PartialGain {
 public:
  /// @param at_most  bounds that are known, of the views around it for example
  PartialGain(const Eigen::Vector3d& view_W, const Gain& at_most) : view_W_(view_W), at_most_(at_most) {}

  /// No less than the gain, in both numbers; the gain itself once it is exact.
  const Gain& at_most() const { return at_most_; }
  /// Elements that have been found to be visible so far.
  int seen() const { return seen_; }
  /// How many are likely to be visible, by the sample; 0 before it, and once it is exact.
  int LikelyVisible() const { return exact_ ? 0 : likely_; }
  /// Whether it has been bounded by itself.
  bool bounded() const { return bounded_; }
  bool exact() const { return exact_; }

  /// The first time bounds this view by itself, then looks at some of the elements that have not been looked
  /// at: a sample, then those under suspicion, then the others.
  void LookFurther(const InformationGain& gain, Suspicion& suspicion);
  void LookToTheEnd(const InformationGain& gain, Suspicion& suspicion);

 private:
  void LowerTo(const Gain& bound);
  void Note(InformationGain::InWindow& element, const Sight& sight, Suspicion& suspicion);
  void Begin(const InformationGain& gain, const Suspicion& suspicion);

  Eigen::Vector3d view_W_;
  Gain at_most_;
  Gain left_;  ///< of elements that have been looked at, and at most of the others
  int seen_ = 0, likely_ = 0;
  bool bounded_ = false, begun_ = false, exact_ = false;
  std::vector<InformationGain::InWindow> elements_;
  std::vector<std::uint32_t> order_;  ///< in which elements_ are looked at
  std::size_t next_ = 0;
};

}  // namespace citrine::planner
