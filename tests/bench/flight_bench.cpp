#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "planner/path/path_search.h"
#include "planner/safety/flight_planner.h"
#include "planner/trajectory/smoother.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;

/// Percentiles of what each iteration took, in ms.
class Laps {
 public:
  template <class Work>
  void Lap(Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    ms_.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  void Report(benchmark::State& state) {
    if (ms_.empty()) return;
    std::sort(ms_.begin(), ms_.end());
    state.counters["p50_ms"] = ms_[ms_.size() / 2];
    state.counters["p95_ms"] = ms_[ms_.size() * 95 / 100];
    state.counters["max_ms"] = ms_.back();
  }

 private:
  std::vector<double> ms_;
};

/// A forest in a volume of the House's size.
const PlanningMap& House() {
  static const PlanningMap map =
      MapOf({45, 40, 20}, DistanceToForest(Forest(1, 45, 60, {3, 3, 3}, {3, 3, 3})));
  return map;
}

Vector3d SafePoint(const ReachableSet& reachable, Random* random) {
  for (;;) {
    const Vector3d p(random->Uniform(1, 44), random->Uniform(1, 39), random->Uniform(1, 19));
    if (reachable.Reaches(p) && reachable.space().Slack(p) >= 0) return p;
  }
}

void FindPath(benchmark::State& state) {
  PathSearch search(House(), {}, 0.1);
  search.Find({3, 3, 3}, {4, 3, 3});
  Random random(1);
  Laps laps;
  for (auto _ : state) {
    const Vector3d from = SafePoint(search.reachable(), &random), to = SafePoint(search.reachable(), &random);
    laps.Lap([&] { benchmark::DoNotOptimize(search.Find(from, to)); });
  }
  laps.Report(state);
}
BENCHMARK(FindPath)->Iterations(300)->Unit(benchmark::kMillisecond);

void FindUnreachable(benchmark::State& state) {
  static const PlanningMap map = MapOf(
      {45, 40, 20}, [](const Vector3d& p) { return std::abs((p - Vector3d(38, 33, 10)).norm() - 4) - 0.3; });
  PathSearch search(map, {}, 0.1);
  search.Find({3, 3, 3}, {4, 3, 3});
  Laps laps;
  for (auto _ : state) laps.Lap([&] { benchmark::DoNotOptimize(search.Find({3, 3, 3}, {38, 33, 10})); });
  laps.Report(state);
}
BENCHMARK(FindUnreachable)->Iterations(50)->Unit(benchmark::kMillisecond);

void FloodReachable(benchmark::State& state) {
  Laps laps;
  for (auto _ : state) {
    ReachableSet reachable(House(), {}, 0.1);
    laps.Lap([&] { reachable.Update({3, 3, 3}); });
  }
  laps.Report(state);
}
BENCHMARK(FloodReachable)->Iterations(20)->Unit(benchmark::kMillisecond);

/// From rest to rest along paths of 5 to 14 m. range(0): weight of time; range(1): of the limits
void SmoothAndCheck(benchmark::State& state) {
  PathSearch search(House(), {}, 0.1);
  search.Find({3, 3, 3}, {4, 3, 3});
  FlightScene scene;
  scene.map = &House();
  FlightWeights weights;
  weights.time = static_cast<double>(state.range(0));
  weights.limits = static_cast<double>(state.range(1));
  const Smoother smoother(200);
  Random random(1);
  Laps laps;
  double evaluations = 0, duration_s = 0;
  int good = 0, count = 0;
  for (auto _ : state) {
    SmoothingTask task;
    for (;;) {
      const Vector3d from = SafePoint(search.reachable(), &random),
                     to = SafePoint(search.reachable(), &random);
      if ((from - to).norm() < 5 || (from - to).norm() > 14) continue;
      const auto path = search.Find(from, to);
      if (!path) continue;
      task.points_W.clear();
      for (const Waypoint& waypoint : path->waypoints) task.points_W.push_back(waypoint.p_W);
      task.start.p = task.points_W.front();
      break;
    }
    laps.Lap([&] {
      const SmoothingResult result = smoother.Solve(scene, weights, task);
      Trajectory motion;
      motion.segments = result.spline.Segments();
      evaluations += result.evaluations;
      duration_s += motion.duration_s();
      good += !FindViolation(motion, 0, scene);
      ++count;
    });
  }
  laps.Report(state);
  state.counters["evaluations"] = evaluations / count;
  state.counters["duration_s"] = duration_s / count;
  state.counters["good_pct"] = 100.0 * good / count;
}
BENCHMARK(SmoothAndCheck)
    ->ArgsProduct({{30, 100}, {10, 30000}})
    ->Iterations(300)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citrine::planner

BENCHMARK_MAIN();
