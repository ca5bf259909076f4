#include "sim/lidar/reachability.h"

#include <algorithm>

namespace citrine::sim {
namespace {

/// What is known of a lattice point while the flood rises; clearances are only measured where it arrives.
enum class Mark : std::uint8_t { kUnknown, kReached, kBlocked };

/// Lattice points around a spawn, those of the cube that it lies in.
std::vector<Eigen::Vector3i> Around(const ReachableLattice& lattice, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3i low = ((p_W - lattice.origin_W) / kLatticeStep_m).array().floor().cast<int>();
  std::vector<Eigen::Vector3i> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(low + Eigen::Vector3i(i & 1, i >> 1 & 1, i >> 2));
  return corners;
}

}  // namespace

std::size_t ReachableLattice::num_reachable() const { return std::ranges::count(reachable, 1); }

ReachableLattice FindReachable(const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                               const std::vector<Eigen::Vector3d>& spawns_W, double radius_m) {
  ReachableLattice lattice;
  lattice.origin_W = volume_W.min();
  lattice.size =
      (volume_W.sizes() / kLatticeStep_m + Eigen::Vector3d::Constant(1 + 1e-6)).array().floor().cast<int>();
  std::vector<Mark> marks(static_cast<std::size_t>(lattice.size.prod()), Mark::kUnknown);
  std::vector<Eigen::Vector3i> front;
  const auto reach = [&](const Eigen::Vector3i& i) {
    if (!lattice.Contains(i)) return;
    Mark& mark = marks[lattice.Linear(i)];
    if (mark != Mark::kUnknown) return;
    mark = scene.Distance(lattice.Position(i), radius_m) >= radius_m ? Mark::kReached : Mark::kBlocked;
    if (mark == Mark::kReached) front.push_back(i);
  };
  for (const Eigen::Vector3d& spawn_W : spawns_W)
    for (const Eigen::Vector3i& corner : Around(lattice, spawn_W)) reach(corner);
  while (!front.empty()) {
    const Eigen::Vector3i i = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) reach(i + step * Eigen::Vector3i::Unit(axis));
  }
  lattice.reachable.resize(marks.size());
  std::ranges::transform(marks, lattice.reachable.begin(), [](Mark mark) { return mark == Mark::kReached; });
  return lattice;
}

}  // namespace citrine::sim
