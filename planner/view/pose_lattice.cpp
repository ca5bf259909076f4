#include "planner/view/pose_lattice.h"

#include <algorithm>
#include <cmath>

namespace citrine::planner {

namespace {

constexpr double kAcross_m = 1.0, kUp_m = 0.5;

int Stride(double step_m, const VoxelGrid& grid) {
  return std::max(1, static_cast<int>(std::lround(step_m / grid.voxel_m())));
}

}  // namespace

PoseLattice::PoseLattice(const VoxelGrid& grid, const Eigen::AlignedBox3d& part_W,
                         const std::function<bool(const Eigen::Vector3d&)>& allowed)
    : grid_(grid),
      allowed_(allowed),
      stride_(Stride(kAcross_m, grid), Stride(kAcross_m, grid), Stride(kUp_m, grid)) {
  if (part_W.isEmpty()) return;
  const Box part = Within(part_W);
  first_ = part.lo;
  size_ = (part.hi - part.lo).cwiseMax(0);
  poses_ = std::vector<Pose>(static_cast<std::size_t>(size_.prod()));
}

PoseLattice::Box PoseLattice::Within(const Eigen::AlignedBox3d& box_W) const {
  const Eigen::Array3i whole =
      (grid_.inside_max() - grid_.inside_min() - VoxelIndex::Ones()).array() / stride_.array() + 1;
  const Eigen::Array3d step_m = grid_.voxel_m() * stride_.cast<double>().array();
  const Eigen::Vector3d first_W = grid_.Centre(grid_.inside_min());
  return {((box_W.min() - first_W).array() / step_m).ceil().cast<int>().max(0),
          (((box_W.max() - first_W).array() / step_m).floor().cast<int>() + 1).min(whole)};
}

PoseLattice::Box PoseLattice::Around(const Eigen::Vector3d& centre_W, double radius_m) const {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius_m);
  const Box around = Within({centre_W - reach, centre_W + reach});
  return {(around.lo - first_).cwiseMax(0), (around.hi - first_).cwiseMin(size_)};
}

Eigen::Vector3d PoseLattice::At(std::size_t pose) const {
  const int i = static_cast<int>(pose);
  return At(Eigen::Vector3i(i % size_.x(), i / size_.x() % size_.y(), i / size_.x() / size_.y()));
}

bool PoseLattice::Allowed(std::size_t pose, const Eigen::Vector3d& p_W) {
  Answer answer = poses_[pose].answer.load(std::memory_order_relaxed);
  if (answer == Answer::kNotAsked) {
    answer = allowed_(p_W) ? Answer::kAllowed : Answer::kForbidden;
    poses_[pose].answer.store(answer, std::memory_order_relaxed);
  }
  return answer == Answer::kAllowed;
}

std::vector<std::size_t> PoseLattice::WithWorth() const {
  std::vector<std::size_t> poses;
  for (std::size_t pose = 0; pose < poses_.size(); ++pose)
    if (worth(pose) > 0) poses.push_back(pose);
  return poses;
}

Eigen::AlignedBox3d PoseLattice::AskedAbout_W() const {
  Eigen::AlignedBox3d asked_W;
  for (std::size_t pose = 0; pose < poses_.size(); ++pose)
    if (poses_[pose].answer != Answer::kNotAsked) asked_W.extend(At(pose));
  return asked_W;
}

}  // namespace citrine::planner
