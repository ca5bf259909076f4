#include "tests/viz/test_scene.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace citrine::viz {

namespace {

using Eigen::Vector3d;

double Box(const Vector3d& p, const Vector3d& centre, const Vector3d& half) {
  const Vector3d q = (p - centre).cwiseAbs() - half;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

double Pole(const Vector3d& p, double x, double y, double radius, double height) {
  return std::max(Eigen::Vector2d(p.x() - x, p.y() - y).norm() - radius, p.z() - height);
}

/// House with a gable roof along x.
double House(const Vector3d& p) {
  const double walls = Box(p, {-7, 4, 2}, {5, 3.5, 2});
  const double roof =
      std::max({(p.z() - 4) * 0.8 + (std::abs(p.y() - 4) - 4) * 0.6, std::abs(p.x() + 7) - 5.6, 3.8 - p.z()});
  const double chimney = Box(p, {-9.5, 5.5, 5}, {0.5, 0.5, 2.6});
  return std::min({walls, roof, chimney});
}

double Playground(const Vector3d& p) {
  double d = Box(p, {9, -7, 2.2}, {1.6, 1.6, 0.25});
  for (const double x : {7.6, 10.4})
    for (const double y : {-8.4, -5.6}) d = std::min(d, Pole(p, x, y, 0.3, 3.6));
  const Vector3d slide(p.x() - 13, p.y() + 7, p.z() - 1.2);
  d = std::min(d, std::max({std::abs(0.88 * slide.z() + 0.47 * slide.x()) - 0.25, std::abs(slide.y()) - 0.8,
                            std::abs(slide.x()) - 2.6}));
  return std::min(d, (p - Vector3d(4, -11, 0.6)).norm() - 1.4);
}

double Settlement(const Vector3d& p) {
  const double cars =
      std::min({Box(p, {8, 9, 0.5}, {2.1, 0.9, 0.5}), Box(p, {7.6, 9, 1.1}, {1.1, 0.8, 0.5}),
                Box(p, {14, 5, 0.5}, {0.9, 2.1, 0.5}), Box(p, {14, 5.3, 1.1}, {0.8, 1.1, 0.5})});
  const double wall = Box(p, {-14, -12, 1}, {5, 0.4, 1.2});
  return std::min({p.z(), House(p), Playground(p), cars, wall});
}

Vector3d Trail(int uav, double t) {
  switch (uav) {
    case 1:
      return {-7 + 8.5 * std::cos(0.13 * t + 2), 4 + 7.5 * std::sin(0.13 * t + 2),
              5 + 2.5 * std::sin(0.05 * t)};
    case 2:
      return {9 + 6 * std::cos(0.16 * t), -7 + 5.5 * std::sin(0.16 * t), 4 + std::sin(0.1 * t)};
    default:
      return {12 + 6.5 * std::cos(0.12 * t - 2.6), 8 + 5 * std::sin(0.12 * t - 2.6),
              3.5 + 0.8 * std::sin(0.07 * t)};
  }
}

constexpr double kNow_s = 47;

SceneUav UavAt(int id) {
  SceneUav uav;
  uav.id = id;
  for (double t = 0; t <= kNow_s; t += 0.1) uav.trail_W.push_back(Trail(id, t));
  for (std::size_t i = 1; i < uav.trail_W.size(); ++i)
    uav.flown_m += (uav.trail_W[i] - uav.trail_W[i - 1]).norm();
  uav.state.X_WB.p = uav.trail_W.back();
  uav.state.v_W = (Trail(id, kNow_s) - Trail(id, kNow_s - 0.1)) / 0.1 * 2.4;
  const double yaw = std::atan2(uav.state.v_W.y(), uav.state.v_W.x());
  uav.state.X_WB.q = Eigen::AngleAxisd(yaw, Vector3d::UnitZ());

  FleetStatus status;
  status.activity = FleetStatus::Activity::kFlying;
  status.has_goal = true;
  status.goal_W = Trail(id, kNow_s + 11) + Vector3d(id == 1 ? -4 : 2, -2, 0);
  uav.status = status;
  Path path;
  for (const double ahead : {0.0, 4.0, 8.0}) path.waypoints.push_back({Trail(id, kNow_s + ahead), 1.2});
  path.waypoints.push_back({status.goal_W, 1.2});
  uav.path = path;
  Trajectory way;
  way.start = FromSeconds(kNow_s);
  TrajectorySegment segment;
  segment.duration_s = 2;
  const Vector3d a = uav.state.X_WB.p, b = Trail(id, kNow_s + 4);
  segment.coefficients.col(0).head<3>() = a;
  segment.coefficients.col(1).head<3>() = uav.state.v_W;
  segment.coefficients.col(2).head<3>() = (b - a - 2 * uav.state.v_W) / 4;
  way.segments.push_back(segment);
  uav.trajectory = way;
  return uav;
}

}  // namespace

std::unique_ptr<PlanningMap> MapOf(const Eigen::AlignedBox3d& volume_W, const Shape& shape,
                                   const SeenFrom& seen_from) {
  const double truncation_m = 0.5;
  const VoxelGrid grid(0.25, volume_W, truncation_m + 0.25);
  const Quantisation quantisation(truncation_m, QualityGoal{}.w_star);
  auto map = std::make_unique<PlanningMap>(grid, quantisation);
  for (int index = 0; index < grid.num_blocks(); ++index) {
    MapBlock block;
    block.index = index;
    block.version = 1;
    const VoxelIndex origin = grid.BlockOrigin(index);
    for (int i = 0; i < kBlockVoxels; ++i) {
      const VoxelIndex v = origin + VoxelIndex(i % 8, i / 8 % 8, i / 64);
      const Vector3d p_W = grid.Centre(v);
      const double distance_m = shape(p_W);
      if (distance_m < -truncation_m) continue;
      const double range_m = seen_from(p_W);
      if (range_m > 10) continue;
      block.distance[i] = quantisation.DistanceCode(distance_m);
      if (std::abs(distance_m) < truncation_m)
        block.weight[i] = quantisation.WeightCode(1 / (range_m * range_m));
    }
    map->Apply(block);
  }
  map->Update();
  return map;
}

TestScene::TestScene() {
  scene.mission = "house";
  scene.strategy = "quality_adaptive, 3 UAVs";
  scene.now = FromSeconds(kNow_s);
  for (int id = 1; id <= 3; ++id) scene.uavs.push_back(UavAt(id));

  const auto seen_from = [&](const Vector3d& p_W) {
    double nearest_m = 100;
    for (const SceneUav& uav : scene.uavs)
      for (std::size_t i = 0; i < uav.trail_W.size(); i += 20)
        nearest_m = std::min(nearest_m, (uav.trail_W[i] - p_W).norm());
    return nearest_m + 0.7 * std::sin(1.3 * p_W.x()) * std::cos(1.1 * p_W.y());
  };
  map = MapOf(volume_W, Settlement, seen_from);
  scene.map = map.get();
  scene.goals =
      QualityGoals({}, {{{Vector3d(5, -13, 0), Vector3d(16, -3, 6)}, QualityGoal::FromDistance(3.5)}});

  Random random(3);
  for (int i = 0; i < 30000; ++i) {
    const Vector3d p_W(random.Uniform(-22, 22), random.Uniform(-19, 19), 0.1);
    const double range_m = seen_from(p_W);
    if (range_m > 9.7 && range_m < 10) scene.incomplete_W.push_back(p_W.cast<float>());
    if (range_m > 4.7 && range_m < 6 && i % 4 == 0) scene.low_quality_W.push_back(p_W.cast<float>());
  }
  scene.progress.surface_voxels = 31240;
  scene.progress.voxels_at_goal = 19463;
  scene.progress.elements_ise = static_cast<int>(scene.incomplete_W.size());
  scene.progress.elements_lqse = 11777;
  scene.progress.z_goal = 0.0494;
  scene.progress.z_bar_sat = 0.0402;
  scene.progress.known_pct = 61.3;
  for (double t = 0; t <= kNow_s; t += 0.5)
    scene.history.push_back({t, 0.66 * (1 - std::exp(-t / 16)) * std::min(1.0, t / 5)});
}

}  // namespace citrine::viz
