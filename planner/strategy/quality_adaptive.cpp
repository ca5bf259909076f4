#include "planner/strategy/quality_adaptive.h"

#include <Eigen/Geometry>

#include "planner/fleet/balance.h"
#include "planner/view/dispersion.h"
#include "planner/view/navigation.h"

namespace citrine::planner {

namespace {

std::vector<ViewTerms> TermsOf(const Situation& situation) {
  const std::vector<View>& views = situation.views;
  const std::vector<double> navigation =
      NavigationScores(views, situation.p_W, situation.v_W, situation.map.grid().voxel_m());
  std::vector<ViewTerms> terms(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const bool mine = !situation.centroid_W_by_uav ||
                      VoronoiCell(views[i].element_W, *situation.centroid_W_by_uav) == situation.uav - 1;
    terms[i] = {views[i].p_W, navigation[i],
                mine ? Dispersion(views[i].p_W, situation.others_W, situation.goals) : 0.0};
  }
  return terms;
}

InformationGain GainOf(const Situation& situation) {
  Eigen::AlignedBox3d views_W;
  for (const View& view : situation.views) views_W.extend(view.p_W);
  std::vector<Element> in_reach;
  for (const Element& element : situation.elements)
    if (views_W.exteriorDistance(element.p_W) <= situation.window.range_max_m()) in_reach.push_back(element);
  return {situation.map, in_reach, situation.window, situation.eta_m};
}

}  // namespace

std::optional<std::size_t> QualityAdaptive::Choose(const Situation& situation, const Accept& accept) {
  const InformationGain gain = GainOf(situation);
  BestView best(gain, TermsOf(situation), weights_);
  for (int offer = 0; offer < kOffers; ++offer) {
    const std::optional<std::size_t> view = best.Next();
    if (!view) break;
    if (accept(situation.views[*view])) return view;
    best.Discard(*view);
  }
  return std::nullopt;
}

std::vector<Score> QualityAdaptive::Scores(const Situation& situation) const {
  const InformationGain gain = GainOf(situation);
  BestView best(gain, TermsOf(situation), weights_);
  std::vector<Score> scores;
  for (std::size_t i = 0; i < situation.views.size(); ++i) scores.push_back(best.ScoreOf(i));
  return scores;
}

}  // namespace citrine::planner
