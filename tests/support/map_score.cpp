#include "tests/support/map_score.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "logs/percentile.h"
#include "logs/surface_samples.h"

namespace citrine::test {
namespace {

constexpr double kCap_m = 1.0, kSamples_per_m2 = 200, kCell_m = 0.08;

/// A mesh, ready to be asked for distances.
sim::RayScene SceneOf(const TriMesh& mesh) {
  sim::World world;
  world.mesh = mesh;
  sim::Part all;
  all.num_triangles = static_cast<int>(mesh.triangles.size());
  world.parts.push_back(all);
  for (const Eigen::Vector3f& p_W : mesh.vertices_W) world.bounds_W.extend(p_W.cast<double>());
  return sim::RayScene(world);
}

}  // namespace

std::vector<Eigen::Vector3f> SeenSurface(const std::vector<LidarScan>& noise_free) {
  std::set<std::array<int, 3>> cells;
  std::vector<Eigen::Vector3f> seen_W;
  for (const LidarScan& scan : noise_free)
    for (int row = 0; row < scan.model.rows; ++row)
      for (int col = 0; col < scan.model.cols; ++col) {
        const float range_m = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
        if (!(range_m > 0)) continue;
        const Eigen::Vector3d p_W = scan.X_WS * (scan.model.Direction(row, col) * range_m);
        const Eigen::Vector3i cell = (p_W / kCell_m).array().floor().cast<int>();
        if (cells.insert({cell.x(), cell.y(), cell.z()}).second) seen_W.push_back(p_W.cast<float>());
      }
  return seen_W;
}

MapScore Score(const TriMesh& mesh, const sim::RayScene& truth, const std::vector<Eigen::Vector3f>& seen_W,
               double voxel_m) {
  MapScore score;
  score.area_m2 = logs::Area(mesh);
  std::vector<float> errors_m;
  for (const Eigen::Vector3f& p_W : logs::SampleSurface(mesh, kSamples_per_m2, 1))
    errors_m.push_back(static_cast<float>(truth.Distance(p_W.cast<double>(), kCap_m)));
  for (const float error_m : errors_m) score.error_mean_m += error_m / static_cast<double>(errors_m.size());
  score.error_p95_m = logs::Percentile(errors_m, 95).value_or(kCap_m);
  const sim::RayScene map = SceneOf(mesh);
  const double near_m = std::sqrt(3.0) / 2 * voxel_m;
  const auto near = std::count_if(seen_W.begin(), seen_W.end(), [&](const Eigen::Vector3f& p_W) {
    return map.Distance(p_W.cast<double>(), 2 * near_m) < near_m;
  });
  score.seen_pct = 100.0 * static_cast<double>(near) / static_cast<double>(seen_W.size());
  return score;
}

}  // namespace citrine::test
