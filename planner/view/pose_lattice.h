#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "core/grid/voxel_grid.h"

namespace citrine::planner {

/// Poses on a lattice over a part of the inside of a grid, 1 m apart across and 0.5 m up, and what each is
/// worth. Several threads may visit them.
class PoseLattice {
 public:
  /// @param part_W  where its poses lie [m]  @param allowed says always the same of a pose; outlives the
  /// lattice
  PoseLattice(const VoxelGrid& grid, const Eigen::AlignedBox3d& part_W,
              const std::function<bool(const Eigen::Vector3d&)>& allowed);

  /// Calls visit(pose, p_W) for every allowed pose within a radius for which counts(pose).
  template <typename Counts, typename Visit>
  void Within(const Eigen::Vector3d& centre_W, double radius_m, const Counts& counts, const Visit& visit) {
    const Box box = Around(centre_W, radius_m);
    Eigen::Vector3i at;
    for (at.z() = box.lo.z(); at.z() < box.hi.z(); ++at.z())
      for (at.y() = box.lo.y(); at.y() < box.hi.y(); ++at.y()) {
        at.x() = box.lo.x();
        std::size_t pose = static_cast<std::size_t>((at.z() * size_.y() + at.y()) * size_.x() + at.x());
        for (; at.x() < box.hi.x(); ++at.x(), ++pose) {
          if (!counts(pose)) continue;
          const Eigen::Vector3d p_W = At(at);
          if ((p_W - centre_W).squaredNorm() <= radius_m * radius_m && Allowed(pose, p_W)) visit(pose, p_W);
        }
      }
  }

  Eigen::Vector3d At(std::size_t pose) const;
  int worth(std::size_t pose) const { return poses_[pose].worth.load(std::memory_order_relaxed); }
  void AddWorth(std::size_t pose, int worth) {
    poses_[pose].worth.fetch_add(worth, std::memory_order_relaxed);
  }
  /// The poses that are worth something so far, ascending.
  std::vector<std::size_t> WithWorth() const;
  /// Around all poses that were in reach of a visit, allowed or not.
  Eigen::AlignedBox3d AskedAbout_W() const;

 private:
  enum class Answer : std::uint8_t { kNotAsked, kAllowed, kForbidden };
  struct Pose {
    std::atomic<int> worth = 0;
    std::atomic<Answer> answer = Answer::kNotAsked;
  };
  struct Box {
    Eigen::Vector3i lo, hi;
  };
  /// Of the whole lattice, of which the poses of this one are a part.
  Box Within(const Eigen::AlignedBox3d& box_W) const;
  Box Around(const Eigen::Vector3d& centre_W, double radius_m) const;
  Eigen::Vector3d At(const Eigen::Vector3i& at) const {
    return grid_.Centre(grid_.inside_min() + stride_.cwiseProduct(first_ + at));
  }
  bool Allowed(std::size_t pose, const Eigen::Vector3d& p_W);

  const VoxelGrid& grid_;
  const std::function<bool(const Eigen::Vector3d&)>& allowed_;
  Eigen::Vector3i stride_;
  Eigen::Vector3i first_ = Eigen::Vector3i::Zero();  ///< of the poses, on the whole lattice
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<Pose> poses_;
};

}  // namespace citrine::planner
