#include "tests/soak/soak_world.h"

#include <cmath>

#include "core/random.h"
#include "planner/path/path_search.h"
#include "sim/world/mesh_builder.h"
#include "sim/world/primitives.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::soak {

namespace {

using Eigen::Vector3d;

constexpr int kTrees = 22;
constexpr double kForest_m = 20, kHeight_m = 8;
constexpr double kWall_m = 0.5, kGap_m = 3;

void Add(const std::string& name, const TriMesh& mesh, const Vector3d& p_W, sim::World* world) {
  sim::Part part;
  part.name = name;
  part.ground = name == "ground";
  sim::AddPart(mesh, Eigen::Affine3d(Eigen::Translation3d(p_W)), part, *world);
}

void AddGround(const Vector3d& size_m, sim::World* world) {
  Add("ground", sim::BoxMesh({size_m.x() + 20, size_m.y() + 20, 0.2}), {size_m.x() / 2, size_m.y() / 2, -0.1},
      world);
}

Scenario Open(const std::string& kind, std::uint64_t seed) {
  Scenario scenario;
  scenario.kind = kind;
  scenario.seed = seed;
  scenario.size_m = {32, 24, 10};
  AddGround(scenario.size_m, &scenario.world);
  return scenario;
}

}  // namespace

Scenario Forest(std::uint64_t seed) {
  const Vector3d size_m(kForest_m, kForest_m, kHeight_m), start(2.5, 2.5, 4), goal(17.5, 17, 4);
  std::vector<planner::Cylinder> trees;
  for (std::uint64_t draw = 0;; ++draw) {
    trees = planner::Forest(seed + 1'000'000 * draw, kForest_m, kTrees, start, goal);
    const PlanningMap map = planner::MapOf(size_m, planner::DistanceToForest(trees));
    planner::PathSearch search(map, {}, 0.3);
    const auto path = search.Find(start, goal);
    if (path && path->ends_at_goal) break;
  }
  Scenario scenario{"forest", size_m, {}, {start}, {goal}, seed};
  AddGround(size_m, &scenario.world);
  for (const planner::Cylinder& tree : trees)
    Add("tree", sim::CylinderMesh(tree.radius_m, kHeight_m), {tree.x, tree.y, kHeight_m / 2},
        &scenario.world);
  sim::Finish("forest", scenario.world);
  return scenario;
}

Scenario HeadOn(std::uint64_t seed, int uavs) {
  Scenario scenario = Open("head-on", seed);
  Random random(seed, 1);
  for (int uav = 0; uav < uavs; ++uav) {
    const double off = random.Uniform(-1, 1), up = random.Uniform(-0.5, 0.5);
    // The third follows the first.
    const Vector3d west(uav == 2 ? 3.5 : 7, 12 + off, 5 + up), east(uav == 2 ? 24.5 : 28, 12 + off, 5 + up);
    scenario.spawns_W.push_back(uav == 1 ? east : west);
    scenario.goals_W.push_back(uav == 1 ? west : east);
  }
  sim::Finish("head-on", scenario.world);
  return scenario;
}

Scenario Crossing(std::uint64_t seed, int uavs) {
  Scenario scenario = Open("crossing", seed);
  Random random(seed, 2);
  const Vector3d centre(16, 12, 5);
  double heading = random.Uniform(0, 2 * EIGEN_PI);
  for (int uav = 0; uav < uavs; ++uav) {
    const Vector3d way(std::cos(heading), std::sin(heading), random.Uniform(-0.05, 0.05));
    scenario.spawns_W.push_back(centre - 9 * way);
    scenario.goals_W.push_back(centre + 9 * way);
    heading += random.Uniform(0.8, 1.6);
  }
  sim::Finish("crossing", scenario.world);
  return scenario;
}

Scenario NarrowGap(std::uint64_t seed, int uavs) {
  Scenario scenario = Open("narrow gap", seed);
  Random random(seed, 3);
  const double gap = random.Uniform(8, 16);
  for (const double side : {-1.0, 1.0}) {
    const double from = side < 0 ? 0 : gap + kGap_m / 2,
                 to = side < 0 ? gap - kGap_m / 2 : scenario.size_m.y();
    Add("wall", sim::BoxMesh({kWall_m, to - from, scenario.size_m.z()}),
        {scenario.size_m.x() / 2, (from + to) / 2, scenario.size_m.z() / 2}, &scenario.world);
  }
  for (int uav = 0; uav < uavs; ++uav) {
    const double y = random.Uniform(4, 8) + 9 * (uav / 2), other_y = random.Uniform(4, 8) + 9 * (uav / 2);
    const Vector3d west(random.Uniform(6, 10), y, 4), east(random.Uniform(22, 26), other_y, 4);
    scenario.spawns_W.push_back(uav == 1 ? east : west);
    scenario.goals_W.push_back(uav == 1 ? west : east);
  }
  sim::Finish("narrow gap", scenario.world);
  return scenario;
}

}  // namespace citrine::soak
