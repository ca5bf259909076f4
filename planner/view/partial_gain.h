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
  PartialGain(const InformationGain& gain, const Eigen::Vector3d& view_W)
      : view_W_(view_W), at_most_(gain.Bound(view_W)) {}

  /// No less than the gain, in both numbers; the gain itself once it is exact.
  const Gain& at_most() const { return at_most_; }
  /// Elements that have been found to be visible so far.
  int seen() const { return seen_; }
  bool exact() const { return exact_; }

  /// Looks at some of the elements that have not been looked at; those under suspicion come first.
  void LookFurther(const InformationGain& gain, Suspicion& suspicion);
  void LookToTheEnd(const InformationGain& gain, Suspicion& suspicion);

 private:
  void Begin(const InformationGain& gain, const Suspicion& suspicion);

  Eigen::Vector3d view_W_;
  Gain at_most_;
  Gain left_;  ///< of elements that have been looked at, and at most of the others
  int seen_ = 0;
  bool begun_ = false, exact_ = false;
  std::vector<InformationGain::InWindow> elements_;
  std::vector<std::uint32_t> order_;  ///< in which elements_ are looked at
  std::size_t next_ = 0;
};

}  // namespace citrine::planner
