#include "modules/explain/decision_text.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numeric>

namespace citrine {
namespace {

using planner::Decision;
using planner::Score;
using planner::View;

[[gnu::format(printf, 2, 3)]] void Append(std::string& text, const char* format, ...) {
  char line[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  text += line;
}

const char* NameOf(View::Kind kind) {
  switch (kind) {
    case View::Kind::kOptimal:
      return "optimal";
    case View::Kind::kClose:
      return "close";
    case View::Kind::kFar:
      return "far";
    case View::Kind::kAround:
      return "off the normal";
  }
  return "";
}

void AppendSituation(const Decision& decision, std::string& text) {
  const planner::Situation& s = decision.situation;
  const double now_s = Seconds(decision.at);
  Append(text, "UAV %d, selection %lld at %d:%04.1f, from (%.1f, %.1f, %.1f) m at %.1f m/s\n", s.uav,
         static_cast<long long>(decision.number), static_cast<int>(now_s / 60), std::fmod(now_s, 60.0),
         s.p_W.x(), s.p_W.y(), s.p_W.z(), s.v_W.norm());
  Append(text, "%zu active elements, %zu views to choose from\n", s.elements.size(), s.views.size());
  for (const Eigen::Vector3d& p_W : s.others_W)
    Append(text, "a teammate counts at (%.1f, %.1f, %.1f) m\n", p_W.x(), p_W.y(), p_W.z());
  if (s.centroid_W_by_uav)
    text += "a correction holds: J_C is 0 for views of elements outside this UAV's share (eq. 16)\n";
}

void AppendRow(const Decision& decision, std::size_t rank, std::size_t i, std::string& text) {
  const Score& score = decision.scores[i];
  const View& view = decision.situation.views[i];
  const bool rejected =
      std::find(decision.without_way.begin(), decision.without_way.end(), i) != decision.without_way.end();
  Append(text, "%c%5zu  %7.4f  %6.4f %6.4f %6.4f  %6.1f m  (%6.1f, %6.1f, %5.1f)  %-14s%s\n",
         i == decision.chosen ? '>' : ' ', rank + 1, score.total, score.information, score.navigation,
         score.coordination, (view.p_W - decision.situation.p_W).norm(), view.p_W.x(), view.p_W.y(),
         view.p_W.z(), NameOf(view.kind), rejected ? "  no way to it" : "");
}

void AppendReason(const Decision& decision, const std::vector<std::size_t>& order, std::string& text) {
  const auto next = std::find_if(order.begin(), order.end(), [&](std::size_t i) {
    return i != decision.chosen && std::find(decision.without_way.begin(), decision.without_way.end(), i) ==
                                       decision.without_way.end();
  });
  if (next == order.end()) {
    text += "chosen: the only view that a way leads to\n";
    return;
  }
  const Score &won = decision.scores[decision.chosen], &second = decision.scores[*next];
  Append(text, "chosen: ahead of the next by %.4f (J_I %+.4f, J_N %+.4f, J_C %+.4f before weighting)\n",
         won.total - second.total, won.information - second.information, won.navigation - second.navigation,
         won.coordination - second.coordination);
}

}  // namespace

std::string DecisionText(const Decision& decision, int rows) {
  std::vector<std::size_t> order(decision.scores.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return decision.scores[a].total > decision.scores[b].total;
  });
  std::string text;
  AppendSituation(decision, text);
  text += "  rank        J     J_I    J_N    J_C  distance  view [m]                 sample\n";
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    if (rank < static_cast<std::size_t>(rows) || order[rank] == decision.chosen)
      AppendRow(decision, rank, order[rank], text);
  AppendReason(decision, order, text);
  return text;
}

}  // namespace citrine
