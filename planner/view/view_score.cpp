#include "planner/view/view_score.h"

#include <algorithm>
#include <numeric>

namespace citrine::planner {

BestView::BestView(const InformationGain& gain, std::vector<ViewTerms> views, const ScoreWeights& weights)
    : gain_(gain),
      views_(std::move(views)),
      weights_(weights),
      bound_(views_.size()),
      exact_(views_.size()),
      known_(views_.size()),
      discarded_(views_.size()) {
  for (std::size_t i = 0; i < views_.size(); ++i) bound_[i] = gain_.Bound(views_[i].p_W);
  FindMostVisible();
}

void BestView::FindMostVisible() {
  std::vector<std::size_t> order(views_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return bound_[a].visible > bound_[b].visible; });
  InformationGain::Hunch hunch = gain_.NoHunch();
  for (const std::size_t i : order) {
    if (bound_[i].visible <= most_visible_) break;
    most_visible_ =
        std::max(most_visible_, gain_.CountVisible(views_[i].p_W, bound_[i], most_visible_ + 1, hunch));
    ++evaluated_;
  }
}

double BestView::Total(std::size_t view, double gain_sum) const {
  const double information = most_visible_ > 0 ? gain_sum / most_visible_ : 0;
  return weights_.alpha * information + weights_.beta * views_[view].navigation +
         weights_.gamma * views_[view].coordination;
}

std::optional<std::size_t> BestView::Next() {
  std::vector<std::pair<double, std::size_t>> order;  // largest bound first, then first in the list
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (!discarded_[i]) order.emplace_back(-Total(i, known_[i] ? exact_[i].sum : bound_[i].sum), i);
  std::sort(order.begin(), order.end());

  std::optional<std::size_t> best;
  double best_total = 0;
  for (const auto& [negative_bound, i] : order) {
    if (best && -negative_bound < best_total) break;
    if (!known_[i]) {
      exact_[i] = gain_.Evaluate(views_[i].p_W);
      known_[i] = true;
      ++evaluated_;
    }
    const double total = Total(i, exact_[i].sum);
    if (!best || total > best_total || (total == best_total && i < *best)) best = i, best_total = total;
  }
  return best;
}

Score BestView::ScoreOf(std::size_t view) const {
  const double information = most_visible_ > 0 ? exact_[view].sum / most_visible_ : 0;
  return {Total(view, exact_[view].sum), information, views_[view].navigation, views_[view].coordination};
}

}  // namespace citrine::planner
