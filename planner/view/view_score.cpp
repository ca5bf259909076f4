#include "planner/view/view_score.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>

namespace citrine::planner {

namespace {
constexpr double kRounding = 1e-9;  ///< far above that of J, which is of the order of one
constexpr double kGroup_m = 1.5;    ///< edge of the cubes of space whose views are bounded together
constexpr double kNoFloor = -std::numeric_limits<double>::infinity();
constexpr double kTooFew = 1.05;  ///< a view that sees so many times an assumed most_visible belies it
constexpr int kHardRound = 4;     ///< in which it is sought everywhere for what sees most
// What views are looked into at a time while it is counted what they see.
constexpr int kEffort = 100, kLookEffort = 3, kBoundEffort = 1;

/// The views in each cube of space, one after the other.
std::vector<std::vector<std::size_t>> Grouped(const std::vector<ViewTerms>& views) {
  const auto cube_of = [&](std::size_t i) {
    const Eigen::Array3i cube = (views[i].p_W.array() / kGroup_m).floor().cast<int>();
    return std::array<int, 3>{cube.x(), cube.y(), cube.z()};
  };
  std::vector<std::pair<std::array<int, 3>, std::size_t>> order;
  for (std::size_t i = 0; i < views.size(); ++i) order.emplace_back(cube_of(i), i);
  std::sort(order.begin(), order.end());
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || order[k].first != order[k - 1].first) groups.emplace_back();
    groups.back().push_back(order[k].second);
  }
  return groups;
}
}  // namespace

BestView::BestView(const InformationGain& gain, std::vector<ViewTerms> views, const ScoreWeights& weights)
    : gain_(gain),
      views_(std::move(views)),
      weights_(weights),
      suspicion_(gain.num_elements()),
      discarded_(views_.size()) {
  for (const ViewTerms& view : views_) gain_of_.emplace_back(view.p_W, Gain());
  for (const std::vector<std::size_t>& group : Grouped(views_)) {
    Eigen::AlignedBox3d box_W;
    for (const std::size_t i : group) box_W.extend(views_[i].p_W);
    const Gain at_most = gain_.Bound(box_W);
    for (const std::size_t i : group) gain_of_[i] = PartialGain(views_[i].p_W, at_most);
    one_of_each_cube_.push_back(group[group.size() / 2]);
  }
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
  for (int effort = 0; effort < kEffort && !queue.empty();) {
    const std::size_t view = queue.top();
    queue.pop();
    effort += gain_of_[view].bounded() ? kLookEffort : kBoundEffort;
    gain_of_[view].LookFurther(gain_, suspicion_);
    if (!gain_of_[view].exact()) queue.push(view);
  }
  const auto likely_sees_less = [](const PartialGain& a, const PartialGain& b) {
    return a.LikelyVisible() < b.LikelyVisible();
  };
  if (!queue.empty())
    std::max_element(gain_of_.begin(), gain_of_.end(), likely_sees_less)->LookToTheEnd(gain_, suspicion_);
}

void BestView::LookEverywhere() {
  const int least = MostVisibleBounds().least;
  for (const std::size_t view : one_of_each_cube_)
    for (int look = 0; look < 2 && gain_of_[view].at_most().visible > least; ++look)
      gain_of_[view].LookFurther(gain_, suspicion_);
}

int BestView::MostVisible() {
  for (;;) {
    const Interval bounds = MostVisibleBounds();
    if (bounds.least == bounds.most) return bounds.most;
    CountFurther();
  }
}

double BestView::Rest(std::size_t view) const {
  return weights_.beta * views_[view].navigation + weights_.gamma * views_[view].coordination;
}

double BestView::Total(std::size_t view, int most_visible) const {
  return weights_.alpha * (gain_of_[view].at_most().sum / most_visible) +
         weights_.beta * views_[view].navigation + weights_.gamma * views_[view].coordination;
}

bool BestView::Alike(std::size_t a, std::size_t b) const {
  return gain_of_[a].at_most().sum == gain_of_[b].at_most().sum &&
         views_[a].navigation == views_[b].navigation && views_[a].coordination == views_[b].coordination;
}

std::optional<BestView::Leader> BestView::LeaderIf(int most_visible, double floor) {
  struct Bound {
    double total;
    std::size_t view;
    bool operator<(const Bound& b) const { return total != b.total ? total < b.total : view > b.view; }
  };
  std::vector<Bound> bounds;
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (!discarded_[i] && weights_.alpha + Rest(i) >= floor) bounds.push_back({Total(i, most_visible), i});
  if (bounds.empty()) return std::nullopt;

  std::priority_queue<Bound> queue(std::less<Bound>(), std::move(bounds));
  bool too_few = false;
  const auto exact_on_top = [&] {
    const std::size_t view = queue.top().view;
    if (gain_of_[view].exact()) return true;
    queue.pop();
    PartialGain& gain = gain_of_[view];
    gain.LookFurther(gain_, suspicion_);
    if (gain.LikelyVisible() > kTooFew * most_visible) gain.LookToTheEnd(gain_, suspicion_);
    too_few = gain.seen() > kTooFew * most_visible;
    queue.push({Total(view, most_visible), view});
    return false;
  };
  while (!exact_on_top())
    if (too_few) return Leader{queue.top().view, false};
  const Bound best = queue.top();
  queue.pop();
  while (!queue.empty() && queue.top().total >= best.total - kRounding) {
    if (!exact_on_top()) {
      if (too_few) return Leader{best.view, false};
      continue;
    }
    if (!Alike(queue.top().view, best.view)) return Leader{best.view, false};
    queue.pop();
  }
  return Leader{best.view, true};
}

std::optional<std::size_t> BestView::Next() {
  for (int round = 1;; ++round) {
    if (round == kHardRound) LookEverywhere();
    CountFurther();
    const int most = MostVisibleBounds().most;
    const std::optional<Leader> many = LeaderIf(most, kNoFloor);
    if (!many) return std::nullopt;
    // J_I is 1 at most: what could not win with it need not be looked at.
    const double floor = Total(many->view, most) - kRounding;
    const int least = MostVisibleBounds().least;
    const std::optional<Leader> few = LeaderIf(least, floor);
    if (few->view == many->view && ((few->clearly && many->clearly) || least == most)) return few->view;
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
