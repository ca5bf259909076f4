#include "planner/strategy/nearest_frontier.h"

#include <algorithm>

namespace citrine::planner {

std::optional<std::size_t> NearestFrontier::Choose(const Situation& situation, const Accept& accept) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < situation.views.size(); ++i)
    order.emplace_back((situation.views[i].p_W - situation.p_W).norm(), i);
  std::sort(order.begin(), order.end());
  for (int offer = 0; offer < std::min<int>(kOffers, static_cast<int>(order.size())); ++offer) {
    const std::size_t view = order[offer].second;
    if (accept(situation.views[view])) return view;
  }
  return std::nullopt;
}

std::vector<Score> NearestFrontier::Scores(const Situation& situation) const {
  std::vector<Score> scores;
  for (const View& view : situation.views) scores.push_back({.total = -(view.p_W - situation.p_W).norm()});
  return scores;
}

}  // namespace citrine::planner
