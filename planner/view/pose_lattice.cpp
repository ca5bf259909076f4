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

PoseLattice::PoseLattice(const VoxelGrid& grid, const std::function<bool(const Eigen::Vector3d&)>& allowed)
    : grid_(grid),
      allowed_(allowed),
      stride_(Stride(kAcross_m, grid), Stride(kAcross_m, grid), Stride(kUp_m, grid)),
      size_((grid.inside_max() - grid.inside_min() - VoxelIndex::Ones()).array() / stride_.array() + 1),
      poses_(static_cast<std::size_t>(size_.prod())) {}

PoseLattice::Box PoseLattice::Around(const Eigen::Vector3d& centre_W, double radius_m) const {
  const Eigen::Array3d step_m = grid_.voxel_m() * stride_.cast<double>().array();
  const Eigen::Array3d middle = (centre_W - At(std::size_t{0})).array() / step_m;
  return {(middle - radius_m / step_m).ceil().cast<int>().max(0),
          ((middle + radius_m / step_m).floor().cast<int>() + 1).min(size_.array())};
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
