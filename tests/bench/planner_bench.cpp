// A decision of the planner on about 8000 elements and 800 views: percentiles of its parts.
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "planner/path/reachable_set.h"
#include "planner/strategy/candidate_views.h"
#include "planner/view/view_score.h"
#include "tests/support/random_map.h"

using namespace citrine;
using namespace citrine::planner;

namespace {
double NowMs() {
  return 1e3 * static_cast<double>(std::clock()) /
         CLOCKS_PER_SEC;  // of this process: other load does not count
}
}  // namespace

int main() {
  std::vector<double> list, make, score, total;
  std::size_t elements_seen = 0, views_seen = 0;
  int evaluated = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    testing::RandomMap world(seed, {26, 26, 12}, 16);
    ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
    surface.Update(world.map);
    ReachableSet reachable(world.map, VehicleLimits(), 0.1);
    reachable.Update(world.Point({26, 26, 8}));
    const SensorWindow window{LidarModel()};
    const ViewGenerator generator(world.map, window,
                                  [&](const Eigen::Vector3d& p_W) {
                                    return reachable.Reaches(p_W) && reachable.space().Slack(p_W) >= 0;
                                  },
                                  {});
    ElementMemory memory(world.map.grid(), 10);
    const double t0 = NowMs();
    const std::vector<Element> elements =
        ListElements(world.map, surface, [](std::uint32_t v) { return v % 3 != 0; });
    const double t1 = NowMs();
    const Candidates candidates =
        MakeCandidates(world.map, elements, generator, true, {13, 13, 4}, {300, 40}, memory);
    const double t2 = NowMs();
    std::vector<ViewTerms> terms;
    for (const View& view : candidates.views)
      terms.push_back({view.p_W, world.random().Uniform() * 0.5, world.random().Uniform()});
    const InformationGain gain(world.map, elements, window, 0.5);
    BestView best(gain, std::move(terms), {});
    best.Next();
    const double t3 = NowMs();
    list.push_back(t1 - t0);
    make.push_back(t2 - t1);
    score.push_back(t3 - t2);
    total.push_back(t3 - t0);
    elements_seen += elements.size();
    views_seen += candidates.views.size();
    evaluated += best.evaluated();
  }
  const auto print = [](const char* name, std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    std::printf("%-10s p50 %6.1f ms  p95 %6.1f ms\n", name, ms[ms.size() / 2], ms[ms.size() * 95 / 100]);
  };
  std::printf("%zu elements, %zu views, %d evaluated (means)\n", elements_seen / 20, views_seen / 20,
              evaluated / 20);
  print("elements", list);
  print("views", make);
  print("score", score);
  print("decision", total);
}
