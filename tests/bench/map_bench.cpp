#include <benchmark/benchmark.h>
#include <dynamicEDT3D/dynamicEDTOctomap.h>
#include <octomap/OcTree.h>

#include "core/map/planning_map.h"
#include "fusion/map_fuser.h"
#include "fusion/surface_mesh.h"
#include "tests/support/analytic_scene.h"

// The same scans for us and for OctoMap (insertPointCloud, discretised) with DynamicEDT3D: quote the ratios
// of one run.
namespace citrine {
namespace {

const Eigen::AlignedBox3d kVolume(Eigen::Vector3d(-20, -20, 0), Eigen::Vector3d(20, 20, 10));

std::vector<LidarScan> Scans(int rows, int cols) {
  test::AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0);
  scene.AddBox({-5, -4, 0}, {5, 4, 6});
  scene.AddBox({9, -3, 0}, {13, -1, 1.6});
  scene.AddBox({8, 6, 0}, {8.1, 6.1, 4});
  for (int i = 0; i < 6; ++i) scene.AddSphere({-10.0 + 4 * i, 9, 2}, 1.2);
  LidarModel model;
  model.rows = rows;
  model.cols = cols;
  Random random(1);
  std::vector<LidarScan> scans;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.1 * i;
    const Pose X_WS{{9 * std::cos(angle), 8 * std::sin(angle), 2.5 + 0.03 * i},
                    Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * std::sin(angle), Eigen::Vector3d::UnitX()))};
    scans.push_back(scene.Scan(X_WS, model, 1.5e-4, &random));
  }
  return scans;
}

octomap::Pointcloud CloudOf(const LidarScan& scan) {
  octomap::Pointcloud cloud;
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const float r = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
      if (!(r > 0)) continue;
      const Eigen::Vector3f p = (scan.X_WS * (scan.model.Direction(row, col) * r)).cast<float>();
      cloud.push_back(p.x(), p.y(), p.z());
    }
  return cloud;
}
octomap::point3d OriginOf(const LidarScan& scan) {
  const Eigen::Vector3f p = scan.X_WS.p.cast<float>();
  return {p.x(), p.y(), p.z()};
}

void BM_FuseScan(benchmark::State& state) {
  const std::vector<LidarScan> scans =
      Scans(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const VoxelGrid grid(0.25, kVolume, 0.75);
  fusion::MapFuser fuser(grid, 0.5, Quantisation(0.5, 1 / (4.5 * 4.5)), fusion::WeightPolicy::kBestView);
  std::size_t i = 0;
  for (auto _ : state) fuser.Integrate(scans[i++ % scans.size()]);
}
BENCHMARK(BM_FuseScan)->Args({32, 512})->Args({64, 720})->Args({16, 360})->Unit(benchmark::kMillisecond);

void BM_OctomapInsert(benchmark::State& state) {
  const std::vector<LidarScan> scans =
      Scans(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::vector<octomap::Pointcloud> clouds;
  for (const LidarScan& scan : scans) clouds.push_back(CloudOf(scan));
  octomap::OcTree tree(0.25);
  std::size_t i = 0;
  for (auto _ : state) {
    tree.insertPointCloud(clouds[i % scans.size()], OriginOf(scans[i % scans.size()]), -1, false, true);
    ++i;
  }
}
BENCHMARK(BM_OctomapInsert)->Args({32, 512})->Args({64, 720})->Args({16, 360})->Unit(benchmark::kMillisecond);

/// Both distance fields after a scan's blocks were applied.
void BM_DistanceFields(benchmark::State& state) {
  const std::vector<LidarScan> scans = Scans(32, 512);
  const VoxelGrid grid(0.25, kVolume, 0.75);
  const Quantisation codes(0.5, 1 / (4.5 * 4.5));
  fusion::MapFuser fuser(grid, 0.5, codes, fusion::WeightPolicy::kBestView);
  PlanningMap map(grid, codes);
  std::size_t i = 0;
  for (auto _ : state) {
    state.PauseTiming();
    fuser.Integrate(scans[i++ % scans.size()]);
    const std::vector<int> changed = fuser.TakeChanged();
    state.ResumeTiming();
    for (const int block : changed) map.Apply(*fuser.Said(block));
    map.Update();
  }
}
BENCHMARK(BM_DistanceFields)->Iterations(60)->Unit(benchmark::kMillisecond);

void BM_DynamicEdt3d(benchmark::State& state) {
  const std::vector<LidarScan> scans = Scans(32, 512);
  octomap::OcTree tree(0.25);
  tree.enableChangeDetection(true);
  DynamicEDTOctomap edt(3.0f, &tree, octomap::point3d(-20, -20, -1), octomap::point3d(20, 20, 10), false);
  std::size_t i = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const LidarScan& scan = scans[i++ % scans.size()];
    tree.insertPointCloud(CloudOf(scan), OriginOf(scan), -1, false, true);
    state.ResumeTiming();
    edt.update();
  }
}
BENCHMARK(BM_DynamicEdt3d)->Iterations(60)->Unit(benchmark::kMillisecond);

void BM_Mesh(benchmark::State& state) {
  fusion::MapFuser fuser(VoxelGrid(0.25, kVolume, 0.75), 0.5, Quantisation(0.5, 1 / (4.5 * 4.5)),
                         fusion::WeightPolicy::kBestView);
  for (const LidarScan& scan : Scans(32, 512)) fuser.Integrate(scan);
  for (auto _ : state) benchmark::DoNotOptimize(fusion::SurfaceMesh(fuser.map()));
}
BENCHMARK(BM_Mesh)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citrine

BENCHMARK_MAIN();
