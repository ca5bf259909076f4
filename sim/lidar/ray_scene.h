#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/world/world.h"

namespace citrine::sim {

/// [m] a point counts as seen when the ray to it is free but for this last piece
inline constexpr double kOcclusionTolerance_m = 0.02;

/// The true world, ready for rays (Embree). Every surface is met from both sides. Queries are const,
/// deterministic and may come from several threads.
class RayScene {
 public:
  explicit RayScene(const World& world);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  std::uint64_t world_hash() const;

  /// Range to the first surface along each ray from one origin; infinity where there is none within
  /// `range_max_m`.
  /// @param directions  unit vectors @param ranges_m  as many as directions
  void Cast(const Eigen::Vector3f& origin_W, std::span<const Eigen::Vector3f> directions, float range_max_m,
            std::span<float> ranges_m) const;

  struct Hit {
    float range_m = std::numeric_limits<float>::infinity();
    int triangle = -1;                              ///< -1: none
    Eigen::Vector3f n_W = Eigen::Vector3f::Zero();  ///< unit normal as the triangle is wound
  };
  /// The first surface along one ray.
  Hit CastOne(const Eigen::Vector3f& origin_W, const Eigen::Vector3f& direction, float range_max_m) const;

  /// Whether a surface stands between two points, the last kOcclusionTolerance_m before `target_W` left out.
  bool Occluded(const Eigen::Vector3f& from_W, const Eigen::Vector3f& target_W) const;

  /// The same for many viewpoints of one target, or (being symmetric but for the tolerance) many targets of
  /// one viewpoint: `free[i]` is set to 1 where nothing stands between from[i] and target[i].
  void Unoccluded(std::span<const Eigen::Vector3f> from_W, std::span<const Eigen::Vector3f> target_W,
                  std::span<std::uint8_t> free) const;

  /// [m] from a point to the nearest surface; `limit_m` where none is nearer than that.
  double Distance(const Eigen::Vector3d& p_W, double limit_m = std::numeric_limits<double>::infinity()) const;

  /// Whether a point lies inside a solid: surfaces wind around it in nearly all of a fixed set of directions,
  /// so that a few missing or wrongly wound triangles do no harm, and open sheets enclose nothing.
  bool Solid(const Eigen::Vector3d& p_W) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace citrine::sim
