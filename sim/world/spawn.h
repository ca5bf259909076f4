#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/lidar/ray_scene.h"

namespace citrine::sim {

/// [m] a start needs this much height above the volume's floor, and a free ball of this radius (design,
/// section 6)
inline constexpr double kSpawnFree_m = 2.25;
/// [m] starts that are placed automatically keep at least this distance
inline constexpr double kSpawnApart_m = 4.0;

/// Whether a UAV may start here: inside the volume, high enough, with a free ball around, not inside a solid.
bool FreeToStart(const RayScene& scene, const Eigen::AlignedBox3d& volume_W, const Eigen::Vector3d& p_W);

/// Start positions of `uavs` UAVs: the first of `given_W`, or, if that is empty, a row near the volume's side
/// of low y. Each is moved by up to `jitter_m` along every axis by the seed, as far as it stays free to
/// start.
/// @throws WorldError naming the UAV, its position, what is near and the nearest free position
std::vector<Eigen::Vector3d> PlaceSpawns(const RayScene& scene, const Eigen::AlignedBox3d& volume_W, int uavs,
                                         const std::vector<Eigen::Vector3d>& given_W, double jitter_m,
                                         std::uint64_t seed);

/// Positions that an automatic placement could use, at most `most` of them.
std::vector<Eigen::Vector3d> FreeStarts(const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                                        double apart_m, int most);

}  // namespace citrine::sim
