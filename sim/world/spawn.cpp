#include "sim/world/spawn.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "core/random.h"

namespace citrine::sim {
namespace {

constexpr double kStep_m = 0.5;         ///< of the lattice on which free positions are looked for
constexpr double kHover_m = 0.25;       ///< automatic starts are this much higher than they must be
constexpr double kGroundWithin_m = 10;  ///< and have something below them this near
constexpr double kFromSide_m = 1.25;    ///< and lie this far from the low side of y
constexpr double kTooNear_m = 1.0;      ///< given starts nearer to each other than this are refused
constexpr std::uint64_t kJitterStream = 11;
constexpr int kJitterHalvings = 6;

std::string Text(const Eigen::Vector3d& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f)", p.x(), p.y(), p.z());
  return text;
}

std::string Text(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", metres);
  return text;
}

/// Points of a lattice inside the volume, from kSpawnFree_m above its floor upwards.
std::vector<Eigen::Vector3d> Lattice(const Eigen::AlignedBox3d& volume_W) {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Vector3d low = volume_W.min() + Eigen::Vector3d(0, 0, kSpawnFree_m), high = volume_W.max();
  for (double z = low.z(); z <= high.z(); z += kStep_m)
    for (double y = low.y(); y <= high.y(); y += kStep_m)
      for (double x = low.x(); x <= high.x(); x += kStep_m) points.emplace_back(x, y, z);
  return points;
}

std::optional<Eigen::Vector3d> NearestFree(const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                                           const Eigen::Vector3d& p_W) {
  std::vector<Eigen::Vector3d> points = Lattice(volume_W);
  std::ranges::stable_sort(points, {}, [&](const Eigen::Vector3d& q) { return (q - p_W).squaredNorm(); });
  const auto free =
      std::ranges::find_if(points, [&](const Eigen::Vector3d& q) { return FreeToStart(scene, volume_W, q); });
  return free == points.end() ? std::nullopt : std::optional(*free);
}

[[noreturn]] void Refuse(const RayScene& scene, const Eigen::AlignedBox3d& volume_W, int uav,
                         const Eigen::Vector3d& p_W) {
  std::string why;
  if (!volume_W.contains(p_W))
    why = "outside the mission volume " + Text(volume_W.min()) + " to " + Text(volume_W.max());
  else if (p_W.z() < volume_W.min().z() + kSpawnFree_m - 1e-9)
    why = "lower than " + Text(kSpawnFree_m) + " above the volume's floor";
  else if (const double distance_m = scene.Distance(p_W); distance_m < kSpawnFree_m)
    why = Text(distance_m) + " from a surface, and a start needs " + Text(kSpawnFree_m) +
          " of free space around";
  else
    why = "inside a solid";
  const std::optional<Eigen::Vector3d> nearest = NearestFree(scene, volume_W, p_W);
  throw WorldError("UAV " + std::to_string(uav) + " cannot start at " + Text(p_W) + ": " + why +
                   (nearest ? "; the nearest free position is " + Text(*nearest)
                            : "; there is no free position in the volume"));
}

/// Moves a start by the seed; where that is not free, by half as much, and so on.
Eigen::Vector3d Jitter(const RayScene& scene, const Eigen::AlignedBox3d& volume_W, const Eigen::Vector3d& p_W,
                       double jitter_m, Random& random) {
  Eigen::Vector3d move;
  for (int axis = 0; axis < 3; ++axis) move[axis] = random.Uniform(-jitter_m, jitter_m);
  for (int halving = 0; halving < kJitterHalvings; ++halving, move /= 2)
    if (FreeToStart(scene, volume_W, p_W + move)) return p_W + move;
  return p_W;
}

bool HasGroundBelow(const RayScene& scene, const Eigen::Vector3d& p_W) {
  return scene.CastOne(p_W.cast<float>(), -Eigen::Vector3f::UnitZ(), static_cast<float>(kGroundWithin_m))
             .triangle >= 0;
}

}  // namespace

bool FreeToStart(const RayScene& scene, const Eigen::AlignedBox3d& volume_W, const Eigen::Vector3d& p_W) {
  return volume_W.contains(p_W) && p_W.z() >= volume_W.min().z() + kSpawnFree_m - 1e-9 &&
         scene.Distance(p_W, kSpawnFree_m) >= kSpawnFree_m - 1e-5 && !scene.Solid(p_W);
}

std::vector<Eigen::Vector3d> FreeStarts(const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                                        double apart_m, int most) {
  std::vector<Eigen::Vector3d> points = Lattice(volume_W);
  for (Eigen::Vector3d& p : points) p += Eigen::Vector3d(0, kFromSide_m, kHover_m);
  const double centre_x = volume_W.center().x();
  std::ranges::stable_sort(points, {}, [&](const Eigen::Vector3d& p) {
    // A low start is preferred to one near the side: a metre up counts as three metres away from it.
    return 3 * (p.z() - volume_W.min().z()) + (p.y() - volume_W.min().y()) + 0.1 * std::abs(p.x() - centre_x);
  });
  std::vector<Eigen::Vector3d> starts;
  for (const Eigen::Vector3d& p : points) {
    if (static_cast<int>(starts.size()) == most) break;
    const auto near = [&](const Eigen::Vector3d& q) { return (p - q).norm() < apart_m; };
    if (std::ranges::none_of(starts, near) && FreeToStart(scene, volume_W, p) && HasGroundBelow(scene, p))
      starts.push_back(p);
  }
  return starts;
}

std::vector<Eigen::Vector3d> PlaceSpawns(const RayScene& scene, const Eigen::AlignedBox3d& volume_W, int uavs,
                                         const std::vector<Eigen::Vector3d>& given_W, double jitter_m,
                                         std::uint64_t seed) {
  std::vector<Eigen::Vector3d> spawns_W = given_W;
  if (given_W.empty()) {
    spawns_W = FreeStarts(scene, volume_W, kSpawnApart_m + 2 * std::sqrt(3.0) * jitter_m, uavs);
    if (static_cast<int>(spawns_W.size()) < uavs)
      throw WorldError("there is room for " + std::to_string(spawns_W.size()) + " of " +
                       std::to_string(uavs) + " UAVs to start: each needs " + Text(kSpawnFree_m) +
                       " of free space around, " + Text(kSpawnApart_m) +
                       " from the others, and ground below");
  }
  if (static_cast<int>(spawns_W.size()) < uavs)
    throw WorldError("mission.spawns_m gives " + std::to_string(spawns_W.size()) + " starts for " +
                     std::to_string(uavs) + " UAVs");
  spawns_W.resize(uavs);
  for (int uav = 1; uav <= uavs; ++uav) {
    const Eigen::Vector3d& p_W = spawns_W[uav - 1];
    if (!FreeToStart(scene, volume_W, p_W)) Refuse(scene, volume_W, uav, p_W);
    for (int other = 1; other < uav; ++other)
      if ((p_W - spawns_W[other - 1]).norm() < kTooNear_m)
        throw WorldError("UAV " + std::to_string(uav) + " cannot start at " + Text(p_W) + ": UAV " +
                         std::to_string(other) + " starts less than " + Text(kTooNear_m) + " away");
  }
  for (int uav = 1; uav <= uavs; ++uav) {
    Random random(seed, kJitterStream + static_cast<std::uint64_t>(uav));
    const Eigen::Vector3d moved_W = Jitter(scene, volume_W, spawns_W[uav - 1], jitter_m, random);
    const auto clash = [&](const Eigen::Vector3d& other_W) {
      return &other_W != &spawns_W[uav - 1] && (other_W - moved_W).norm() < kTooNear_m;
    };
    if (std::ranges::none_of(spawns_W, clash)) spawns_W[uav - 1] = moved_W;
  }
  return spawns_W;
}

}  // namespace citrine::sim
