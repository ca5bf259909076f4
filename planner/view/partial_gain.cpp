#include "planner/view/partial_gain.h"

#include <algorithm>

#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {
constexpr std::size_t kAtATime = 48;
constexpr double kOutOfSight = 0.5;  ///< vis below which an element is under suspicion
constexpr double kRounding = 1e-9;   ///< above that of a sum of bounds
}  // namespace

void PartialGain::Begin(const InformationGain& gain, const Suspicion& suspicion) {
  begun_ = true;
  gain.AppendInWindow(view_W_, elements_);
  left_ = {kRounding, static_cast<int>(elements_.size())};
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < elements_.size(); ++i) {
    const InformationGain::InWindow& e = elements_[i];
    left_.sum += e.worth;
    (e.averted || suspicion[e.element] & e.sector ? order_ : others).push_back(i);
  }
  order_.insert(order_.end(), others.begin(), others.end());
}

void PartialGain::LookFurther(const InformationGain& gain, Suspicion& suspicion) {
  if (exact_) return;
  if (!begun_) Begin(gain, suspicion);
  const std::size_t end = std::min(order_.size(), next_ + kAtATime);
  for (; next_ < end; ++next_) {
    InformationGain::InWindow& e = elements_[order_[next_]];
    const Sight sight = gain.Look(e, view_W_);
    const double vis = Visibility(sight);
    seen_ += sight.clear;
    left_.visible -= !sight.clear;
    left_.sum -= e.worth * (1 - vis);
    e.worth *= vis;
    if (vis < kOutOfSight)
      suspicion[e.element] |= e.sector;
    else
      suspicion[e.element] &= ~e.sector;
  }
  if (next_ < order_.size()) {
    at_most_ = {std::min(at_most_.sum, left_.sum), std::min(at_most_.visible, left_.visible)};
    return;
  }
  exact_ = true;
  at_most_ = {0, left_.visible};
  for (const InformationGain::InWindow& e : elements_) at_most_.sum += e.worth;
  elements_ = {};
  order_ = {};
}

void PartialGain::LookToTheEnd(const InformationGain& gain, Suspicion& suspicion) {
  while (!exact_) LookFurther(gain, suspicion);
}

}  // namespace citrine::planner
