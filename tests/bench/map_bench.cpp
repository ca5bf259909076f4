#include <algorithm>
#include <cstdio>
#include <cstring>

#include <dynamicEDT3D/dynamicEDTOctomap.h>
#include <octomap/OcTree.h>

#include "core/map/planning_map.h"
#include "fusion/block_rotation.h"
#include "fusion/map_fuser.h"
#include "fusion/surface_mesh.h"
#include "modules/codec/map_blocks.h"
#include "tests/bench/cpu_clock.h"
#include "tests/support/house_flight.h"
#include "tests/support/map_score.h"
#include "tests/support/ray_integrator.h"

// The map of the House, side by side with OctoMap (insertPointCloud, discretised) and DynamicEDT3D on the
// same scans of our own emulator, one after the other scan by scan in one run, in time on one processor.
namespace citrine::bench {
namespace {

constexpr double kTruncation_vox = 2.0;
const double kWeightMax = 1 / (4.5 * 4.5);

VoxelGrid Grid(double voxel_m) {
  return VoxelGrid(voxel_m, test::kHouseVolume_W, (kTruncation_vox + 1) * voxel_m);
}
fusion::MapFuser Fuser(double voxel_m) {
  return fusion::MapFuser(Grid(voxel_m), kTruncation_vox * voxel_m,
                          Quantisation(kTruncation_vox * voxel_m, kWeightMax),
                          fusion::WeightPolicy::kBestView);
}

struct Cloud {
  octomap::Pointcloud points;
  octomap::point3d origin;
};
Cloud CloudOf(const LidarScan& scan) {
  const Eigen::Vector3f origin = scan.X_WS.p.cast<float>();
  Cloud cloud{{}, {origin.x(), origin.y(), origin.z()}};
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const float r = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
      if (!(r > 0)) continue;
      const Eigen::Vector3f p = (scan.X_WS * (scan.model.Direction(row, col) * r)).cast<float>();
      cloud.points.push_back(p.x(), p.y(), p.z());
    }
  return cloud;
}

/// @param carve  whether beams without return carve, too; OctoMap hears of returns alone
void Integration(const test::HouseFlight& flight, int rows, int cols, double voxel_m, int scans, bool carve) {
  fusion::MapFuser fuser = Fuser(voxel_m);
  octomap::OcTree tree(voxel_m);
  Samples ours, octomap, points;
  for (LidarScan& scan : flight.Scans(rows, cols)) {
    if (static_cast<int>(ours.values.size()) == scans) break;
    if (!carve) std::replace(scan.ranges_m.begin(), scan.ranges_m.end(), kNoReturn, kInvalid);
    const Cloud cloud = CloudOf(scan);
    ours.Add(TimeMs([&] { fuser.Integrate(scan); }));
    octomap.Add(TimeMs([&] { tree.insertPointCloud(cloud.points, cloud.origin, -1, false, true); }));
    points.Add(static_cast<double>(cloud.points.size()));
  }
  std::printf(
      "integration %2dx%3d, %.2f m, %s: %6.3f ms a scan (median %6.3f), OctoMap %7.3f (%7.3f): %5.1fx; %zu "
      "scans "
      "of %.0f returns\n",
      rows, cols, voxel_m, carve ? "carving" : "returns", ours.mean(), ours.median(), octomap.mean(),
      octomap.median(), octomap.sum() / ours.sum(), ours.values.size(), points.mean());
}

void Print(const char* who, const test::MapScore& score) {
  std::printf("%-30s mean %.4f m, p95 %.4f m, %.2f %% of what was seen, %.0f m2\n", who, score.error_mean_m,
              score.error_p95_m, score.seen_pct, score.area_m2);
}

void Accuracy(const test::HouseFlight& flight, int rows, int cols) {
  const std::vector<LidarScan> scans = flight.Scans(rows, cols);
  fusion::MapFuser fuser = Fuser(0.25);
  TsdfMap exact(Grid(0.25), kTruncation_vox * 0.25);
  test::RayIntegrator rays(exact);
  for (const LidarScan& scan : scans) {
    fuser.Integrate(scan);
    rays.Integrate(scan);
  }
  const auto seen_W = test::SeenSurface(flight.Scans(rows, cols, 0));
  std::printf("accuracy %dx%d\n", rows, cols);
  Print("  projective", test::Score(fusion::SurfaceMesh(fuser.map()), *flight.scene(), seen_W, 0.25));
  Print("  every ray (the oracle)", test::Score(fusion::SurfaceMesh(exact), *flight.scene(), seen_W, 0.25));
}

/// A scan of each of three UAVs, a third of the tour apart, then both fields against DynamicEDT3D's one.
void Fields(const test::HouseFlight& flight) {
  const std::vector<LidarScan> scans = flight.Scans(64, 720);
  fusion::MapFuser fuser = Fuser(0.25);
  PlanningMap map(Grid(0.25), Quantisation(0.5, kWeightMax));
  octomap::OcTree tree(0.25);
  tree.enableChangeDetection(true);
  DynamicEDTOctomap edt(static_cast<float>(PlanningMap::kOccupiedReach_m), &tree,
                        octomap::point3d(-22.5, -20, -1), octomap::point3d(22.5, 20, 20), false);
  Samples quantise, ours, theirs, bytes, coding;
  const std::size_t third = scans.size() / 3;
  for (std::size_t i = 0; i < third; ++i) {
    for (const std::size_t uav : {0u, 1u, 2u}) {
      fuser.Integrate(scans[i + uav * third]);
      const Cloud cloud = CloudOf(scans[i + uav * third]);
      tree.insertPointCloud(cloud.points, cloud.origin, -1, false, true);
    }
    std::vector<int> changed;
    quantise.Add(TimeMs([&] { changed = fuser.TakeChanged(); }));
    std::vector<MapBlock> blocks;
    for (const int block : changed) blocks.push_back(*fuser.Said(block));
    ours.Add(TimeMs([&] {
      for (const MapBlock& block : blocks) map.Apply(block);
      map.Update();
    }));
    theirs.Add(TimeMs([&] { edt.update(); }));
    coding.Add(TimeMs([&] {
      double sum = 0;
      for (const auto& message : EncodeInMessages(blocks)) sum += message.getEncodedSize();
      bytes.Add(sum);
    }));
  }
  std::printf(
      "both distance fields: %.3f ms a round of three scans (median %.3f), DynamicEDT3D's one %.3f (%.3f): "
      "%.2fx\n",
      ours.mean(), ours.median(), theirs.mean(), theirs.median(), theirs.sum() / ours.sum());
  std::printf("quantising %.3f ms, coding %.3f ms for %.0f bytes a round\n", quantise.mean(), coding.mean(),
              bytes.mean());
}

/// What the base station says of the map while three UAVs each fly a third of the tour, ten scans a second:
/// changed blocks and a twentieth of the rest twice a second, and the mesh in pieces as a viewer follows it.
void Traffic(const test::HouseFlight& flight) {
  const std::vector<LidarScan> scans = flight.Scans(32, 512);
  fusion::MapFuser fuser = Fuser(0.25);
  fusion::BlockRotation rotation(fuser.map().grid().num_blocks(), 20);
  fusion::BlockMeshes meshes(fuser.map());
  Samples bytes, changed_blocks, pieces_ms;
  const std::size_t third = scans.size() / 3;
  for (std::size_t i = 0; i < third; ++i) {
    for (const std::size_t uav : {0u, 1u, 2u}) fuser.Integrate(scans[i + uav * third]);
    if (i % 5 != 4) continue;
    const std::vector<int> changed = fuser.TakeChanged(), next = rotation.Next(changed);
    std::vector<MapBlock> blocks;
    for (std::size_t k = 0; k < next.size(); ++k) {
      if (k >= changed.size()) fuser.Renew(next[k]);
      blocks.push_back(*fuser.Said(next[k]));
    }
    double sum = 0;
    for (const auto& message : EncodeInMessages(blocks)) sum += message.getEncodedSize();
    bytes.Add(sum);
    changed_blocks.Add(static_cast<double>(changed.size()));
    pieces_ms.Add(TimeMs([&] { meshes.Update(changed); }));
  }
  std::printf("traffic: %.1f kB/s, %.0f changed blocks at a time; their mesh %.2f ms\n", 2e-3 * bytes.mean(),
              changed_blocks.mean(), pieces_ms.mean());
}

void Mesh(const test::HouseFlight& flight) {
  fusion::MapFuser fuser = Fuser(0.25);
  for (const LidarScan& scan : flight.Scans(64, 720)) fuser.Integrate(scan);
  Samples whole;
  std::size_t triangles = 0;
  for (int i = 0; i < 10; ++i)
    whole.Add(TimeMs([&] { triangles = fusion::SurfaceMesh(fuser.map()).triangles.size(); }));
  const PlanningMap map(fuser.map().grid(), Quantisation(0.5, kWeightMax));
  std::printf(
      "mesh of the whole map: %.2f ms, %zu triangles; TSDF and confidence %.1f MB, both fields %.1f MB\n",
      whole.median(), triangles, 1e-6 * static_cast<double>(fuser.map().bytes()),
      1e-6 * static_cast<double>(map.to_occupied().bytes() + map.to_unknown().bytes()));
}

int Main(int argc, char** argv) {
  StayOnOneCore();
  const test::HouseFlight flight;
  const auto asked = [&](const char* part) { return argc < 2 || std::strstr(argv[1], part) != nullptr; };
  if (asked("integration")) {
    for (const bool carve : {false, true}) {
      Integration(flight, 64, 720, 0.25, test::HouseFlight::kPoses, carve);
      Integration(flight, 16, 360, 0.25, test::HouseFlight::kPoses, carve);
      Integration(flight, 64, 720, 0.10, 40, carve);
    }
  }
  if (asked("fields")) Fields(flight);
  if (asked("mesh")) Mesh(flight);
  if (asked("traffic")) Traffic(flight);
  if (asked("accuracy"))
    for (const auto& [rows, cols] : {std::pair{64, 720}, {32, 512}, {16, 360}}) Accuracy(flight, rows, cols);
  return 0;
}

}  // namespace
}  // namespace citrine::bench

int main(int argc, char** argv) { return citrine::bench::Main(argc, argv); }
