// Decisions of the planner by the paper's letter on random maps: percentiles of their parts, and the plain
// double loop of eq. (8) over the same views beside them, which must choose the same.
//
// Random maps are the harsher case: obstacles and unknown space all over, so that bounds say little and many
// views are nearly as good. What a decision takes in a mission is replan_ms_p95 in metrics.json of
// ./citrine run house --in-process --set planner.candidates=all --set planner.hop_min_m=0
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "planner/path/reachable_set.h"
#include "planner/strategy/candidate_views.h"
#include "planner/view/dispersion.h"
#include "planner/view/navigation.h"
#include "planner/view/view_score.h"
#include "planner/view/visibility.h"
#include "tests/support/random_map.h"

using namespace citrine;
using namespace citrine::planner;

namespace {

double NowMs() {
  return 1e3 * static_cast<double>(std::clock()) /
         CLOCKS_PER_SEC;  // of this process: other load does not count
}

/// The arg max of eq. (6) as it is written: every view, every element, every voxel in between.
std::size_t PlainChoice(const PlanningMap& map, const std::vector<Element>& elements,
                        const std::vector<ViewTerms>& views, const SensorWindow& window) {
  std::vector<double> sums;
  int most = 1;
  for (const ViewTerms& view : views) {
    double sum = 0;
    int visible = 0;
    for (const Element& e : elements) {
      const Eigen::Vector3d to = e.p_W - view.p_W;
      if (!window.Sees(to)) continue;
      const Sight sight = LookAt(map, e, view.p_W);
      visible += sight.clear;
      sum += DistanceWorth(to.norm(), e.d_star_m, 0.5, window.range_max_m()) * Visibility(sight);
    }
    sums.push_back(sum);
    most = std::max(most, visible);
  }
  std::size_t best = 0;
  double best_total = -1;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double total = sums[i] / most + views[i].navigation + 2 * views[i].coordination;
    if (total > best_total + 1e-12) best = i, best_total = total;
  }
  return best;
}

struct Decision {
  double list_ms, make_ms, score_ms, all_ms, plain_ms;
  std::size_t elements, views;
  int evaluated;
};

/// Of each `of` voxels `kept` are up for choice.
struct Share {
  std::uint32_t kept, of;
};

Decision Decide(std::uint64_t seed, const Share& share) {
  testing::RandomMap world(seed, {26, 26, 12}, 16);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  surface.Update(world.map);
  ReachableSet reachable(world.map, VehicleLimits(), 0.1);
  reachable.Update(world.Point({26, 26, 8}));
  const SensorWindow window{LidarModel()};
  const ViewGenerator generator(
      world.map, window,
      [&](const Eigen::Vector3d& p_W) { return reachable.Reaches(p_W) && reachable.space().Slack(p_W) >= 0; },
      {});
  ElementMemory memory(world.map.grid(), 10);
  const Eigen::Vector3d p_W{13, 13, 4}, v_W{2, 0, 0};
  const auto skip = [&](std::uint32_t v) { return v % share.of >= share.kept; };
  {  // a planner has decided before: what it makes once is made
    ElementMemory none(world.map.grid(), 10);
    SearchBudget budget{300, 40};
    MakeCandidates(world.map, ListElements(world.map, surface, skip), generator, true, p_W, budget, none);
  }
  const double t0 = NowMs();
  const std::vector<Element> elements = ListElements(world.map, surface, skip);
  const double t1 = NowMs();
  SearchBudget budget{300, 40};
  const Candidates candidates = MakeCandidates(world.map, elements, generator, true, p_W, budget, memory);
  const double t2 = NowMs();
  const std::vector<Eigen::Vector3d> others_W{{5, 20, 3}, {20, 18, 5}};
  const std::vector<double> navigation = NavigationScores(candidates.views, p_W, v_W, 0.25);
  std::vector<ViewTerms> terms;
  for (std::size_t i = 0; i < candidates.views.size(); ++i) {
    const Eigen::Vector3d& view_W = candidates.views[i].p_W;
    terms.push_back({view_W, navigation[i], Dispersion(view_W, others_W, surface.goals())});
  }
  const double t3 = NowMs();
  const InformationGain gain(world.map, elements, window, 0.5);
  BestView best(gain, terms, {});
  const std::optional<std::size_t> choice = best.Next();
  const double t4 = NowMs();
  const std::size_t plain = PlainChoice(world.map, elements, terms, window);
  const double t5 = NowMs();
  if (choice != plain) {
    std::printf("seed %d: the choice differs from the plain loop's\n", static_cast<int>(seed));
    std::exit(1);
  }
  return {t1 - t0,         t2 - t1, t4 - t3, t4 - t0, t5 - t4, elements.size(), candidates.views.size(),
          best.evaluated()};
}

void Print(const char* name, const std::vector<Decision>& decisions, double (*of)(const Decision&)) {
  std::vector<double> values;
  for (const Decision& decision : decisions) values.push_back(of(decision));
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  std::printf("  %-22s p50 %8.1f  p95 %8.1f  max %8.1f\n", name, values[(n + 1) / 2 - 1],
              values[(95 * n + 99) / 100 - 1], values[n - 1]);
}

}  // namespace

int main() {
  for (const auto& [share, count] :
       {std::pair<Share, std::uint64_t>{{1, 3}, 20}, {{4, 5}, 40}, {{1, 1}, 20}}) {
    std::vector<Decision> decisions;
    for (std::uint64_t seed = 1; seed <= count; ++seed) decisions.push_back(Decide(seed, share));
    std::printf("%zu decisions, %u of %u elements\n", decisions.size(), share.kept, share.of);
    Print("elements", decisions, [](const Decision& d) { return static_cast<double>(d.elements); });
    Print("views", decisions, [](const Decision& d) { return static_cast<double>(d.views); });
    Print("views evaluated", decisions, [](const Decision& d) { return static_cast<double>(d.evaluated); });
    Print("list elements [ms]", decisions, [](const Decision& d) { return d.list_ms; });
    Print("make views [ms]", decisions, [](const Decision& d) { return d.make_ms; });
    Print("score [ms]", decisions, [](const Decision& d) { return d.score_ms; });
    Print("decision [ms]", decisions, [](const Decision& d) { return d.all_ms; });
    Print("plain loop [ms]", decisions, [](const Decision& d) { return d.plain_ms; });
    Print("plain loop / score", decisions, [](const Decision& d) { return d.plain_ms / d.score_ms; });
  }
}
