#include "planner/view/view_score.h"

#include <algorithm>
#include <queue>

namespace citrine::planner {

namespace {
constexpr double kRounding = 1e-9;  ///< far above that of J, which is of the order of one
constexpr int kLooksAtATime = 64;
}  // namespace

BestView::BestView(const InformationGain& gain, std::vector<ViewTerms> views, const ScoreWeights& weights)
    : gain_(gain),
      views_(std::move(views)),
      weights_(weights),
      suspicion_(gain.num_elements()),
      discarded_(views_.size()) {
  gain_of_.reserve(views_.size());
  for (const ViewTerms& view : views_) gain_of_.emplace_back(gain_, view.p_W);
}

BestView::Interval BestView::MostVisibleBounds() const {
  Interval bounds{1, 1};
  for (const PartialGain& gain : gain_of_) {
    bounds.most = std::max(bounds.most, gain.at_most().visible);
    bounds.least = std::max(bounds.least, gain.seen());
  }
  return bounds;
}

void BestView::CountFurther() {
  const auto sees_less = [&](std::size_t a, std::size_t b) {
    const int sees_a = gain_of_[a].at_most().visible, sees_b = gain_of_[b].at_most().visible;
    return sees_a != sees_b ? sees_a < sees_b : a > b;
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(sees_less)> queue(sees_less);
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (!gain_of_[i].exact()) queue.push(i);
  std::size_t promising = 0;
  for (int look = 0; look < kLooksAtATime && !queue.empty(); ++look) {
    const std::size_t view = queue.top();
    queue.pop();
    gain_of_[view].LookFurther(gain_, suspicion_);
    if (!gain_of_[view].exact()) queue.push(view);
    if (look == 0 || gain_of_[view].seen() > gain_of_[promising].seen()) promising = view;
  }
  if (!gain_of_.empty()) gain_of_[promising].LookToTheEnd(gain_, suspicion_);
}

int BestView::MostVisible() {
  for (;;) {
    const Interval bounds = MostVisibleBounds();
    if (bounds.least == bounds.most) return bounds.most;
    CountFurther();
  }
}

double BestView::Total(std::size_t view, int most_visible) const {
  return weights_.alpha * (gain_of_[view].at_most().sum / most_visible) +
         weights_.beta * views_[view].navigation + weights_.gamma * views_[view].coordination;
}

bool BestView::Alike(std::size_t a, std::size_t b) const {
  return gain_of_[a].at_most().sum == gain_of_[b].at_most().sum &&
         views_[a].navigation == views_[b].navigation && views_[a].coordination == views_[b].coordination;
}

std::optional<BestView::Leader> BestView::LeaderIf(int most_visible) {
  struct Bound {
    double total;
    std::size_t view;
    bool operator<(const Bound& b) const { return total != b.total ? total < b.total : view > b.view; }
  };
  std::vector<Bound> bounds;
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (!discarded_[i]) bounds.push_back({Total(i, most_visible), i});
  if (bounds.empty()) return std::nullopt;

  std::priority_queue<Bound> queue(std::less<Bound>(), std::move(bounds));
  const auto exact_on_top = [&] {
    const std::size_t view = queue.top().view;
    if (gain_of_[view].exact()) return true;
    queue.pop();
    gain_of_[view].LookFurther(gain_, suspicion_);
    queue.push({Total(view, most_visible), view});
    return false;
  };
  while (!exact_on_top()) {
  }
  const Bound best = queue.top();
  queue.pop();
  while (!queue.empty() && queue.top().total >= best.total - kRounding) {
    if (!exact_on_top()) continue;
    if (!Alike(queue.top().view, best.view)) return Leader{best.view, false};
    queue.pop();
  }
  return Leader{best.view, true};
}

std::optional<std::size_t> BestView::Next() {
  CountFurther();
  for (;;) {
    const auto [least, most] = MostVisibleBounds();
    const auto few = LeaderIf(least), many = LeaderIf(most);
    if (!few) return std::nullopt;
    if (few->view == many->view && ((few->clearly && many->clearly) || least == most)) return few->view;
    CountFurther();
  }
}

Score BestView::ScoreOf(std::size_t view) {
  const int most_visible = MostVisible();
  gain_of_[view].LookToTheEnd(gain_, suspicion_);
  return {Total(view, most_visible), gain_of_[view].at_most().sum / most_visible, views_[view].navigation,
          views_[view].coordination};
}

int BestView::evaluated() const {
  return static_cast<int>(
      std::count_if(gain_of_.begin(), gain_of_.end(), [](const PartialGain& gain) { return gain.exact(); }));
}

}  // namespace citrine::planner
