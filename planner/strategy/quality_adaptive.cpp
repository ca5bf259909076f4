#include "planner/strategy/quality_adaptive.h"

#include "planner/fleet/balance.h"
#include "planner/view/dispersion.h"
#include "planner/view/navigation.h"

namespace citrine::planner {

std::optional<std::size_t> QualityAdaptive::Choose(const Situation& situation, const Accept& accept) {
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
  const InformationGain gain(situation.map, situation.elements, situation.window, situation.eta_m);
  BestView best(gain, std::move(terms), weights_);
  for (int offer = 0; offer < kOffers; ++offer) {
    const std::optional<std::size_t> view = best.Next();
    if (!view) break;
    if (accept(views[*view])) return view;
    best.Discard(*view);
  }
  return std::nullopt;
}

}  // namespace citrine::planner
