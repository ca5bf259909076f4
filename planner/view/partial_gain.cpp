#include "planner/view/partial_gain.h"

#include <algorithm>

#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {
constexpr std::size_t kAtATime = 48;
constexpr double kOutOfSight = 0.5;  ///< vis below which an element is under suspicion
constexpr double kRounding = 1e-9;   ///< above that of a sum of bounds
}  // namespace

void PartialGain::LowerTo(const Gain& bound) {
  at_most_ = {std::min(at_most_.sum, bound.sum), std::min(at_most_.visible, bound.visible)};
}

void PartialGain::Begin(const InformationGain& gain, const Suspicion& suspicion) {
  begun_ = true;
  elements_.reserve(static_cast<std::size_t>(at_most_.visible));
  gain.AppendInWindow(view_W_, elements_);
  left_ = {kRounding, static_cast<int>(elements_.size())};
  std::vector<std::uint32_t> suspects, others;
  const std::size_t stride = elements_.size() / kAtATime + 1;
  for (std::uint32_t i = 0; i < elements_.size(); ++i) {
    const InformationGain::InWindow& e = elements_[i];
    left_.sum += e.worth;
    if (i % stride == 0)
      order_.push_back(i);
    else
      (e.averted || suspicion[e.element] & e.sector ? suspects : others).push_back(i);
  }
  order_.insert(order_.end(), suspects.begin(), suspects.end());
  order_.insert(order_.end(), others.begin(), others.end());
}

void PartialGain::Note(InformationGain::InWindow& e, const Sight& sight, Suspicion& suspicion) {
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

void PartialGain::LookFurther(const InformationGain& gain, Suspicion& suspicion) {
  if (exact_) return;
  if (!bounded_) {
    bounded_ = true;
    LowerTo(gain.Bound(view_W_));
    return;
  }
  if (!begun_) Begin(gain, suspicion);
  const std::size_t end = std::min(order_.size(), next_ + kAtATime);
  for (; next_ < end; next_ += 8) {
    std::array<int, 8> elements;
    for (std::size_t k = 0; k < 8; ++k) elements[k] = elements_[order_[std::min(next_ + k, end - 1)]].element;
    const std::array<Sight, 8> sights = gain.Look(elements, view_W_);
    for (std::size_t k = 0; k < std::min<std::size_t>(8, end - next_); ++k)
      Note(elements_[order_[next_ + k]], sights[k], suspicion);
  }
  next_ = end;
  if (likely_ == 0 && end > 0)
    likely_ = static_cast<int>(static_cast<std::size_t>(seen_) * elements_.size() / end);
  if (next_ < order_.size()) {
    LowerTo(left_);
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
