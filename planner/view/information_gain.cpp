#include "planner/view/information_gain.h"

#include <algorithm>
#include <cmath>

#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {
constexpr double kBucket_m = 3.0;
constexpr float kSlack_m = 1e-3f;  ///< by which float bounds are widened; far above their rounding
int OccupiedFaces(const PlanningMap& map, const VoxelIndex& v) {
  int bits = 0;
  for (int direction = 0; direction < 6; ++direction) {
    VoxelIndex n = v;
    n[direction / 2] += direction % 2 ? 1 : -1;
    if (map.grid().Contains(n) && map.state(map.grid().Linear(n)) == VoxelState::kOccupied)
      bits |= 1 << direction;
  }
  return bits;
}

}  // namespace

double DistanceWorth(double distance_m, double d_star_m, double eta_m, double range_max_m) {
  if (distance_m > range_max_m) return 0;
  if (std::abs(distance_m - d_star_m) < eta_m) return 1;
  return distance_m < d_star_m ? 0.5 : 0.5 * (1 - distance_m / range_max_m);
}

InformationGain::InformationGain(const PlanningMap& map, const std::vector<Element>& elements,
                                 const SensorWindow& window, double eta_m)
    : map_(map), window_(window), eta_m_(eta_m), clear_(map) {
  const VoxelGrid& grid = map.grid();
  std::vector<std::pair<int, int>> order;  // bucket, element
  const Eigen::Vector3i cells =
      (grid.voxels().cast<double>() * grid.voxel_m() / kBucket_m).array().ceil().cast<int>();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Eigen::Vector3i c = ((elements[i].p_W - grid.origin_W()) / kBucket_m).cast<int>();
    order.emplace_back(c.x() + cells.x() * (c.y() + cells.y() * c.z()), static_cast<int>(i));
  }
  std::sort(order.begin(), order.end());
  elements_.reserve(elements.size());
  int last_bucket = -1;
  for (const auto& [bucket, i] : order) {
    const Element& e = elements[i];
    const Eigen::Vector3f p = e.p_W.cast<float>();
    if (bucket != last_bucket) {
      const int at = static_cast<int>(elements_.size());
      buckets_.push_back({p, p, at, at});
      last_bucket = bucket;
    }
    Bucket& b = buckets_.back();
    b.min_W = b.min_W.cwiseMin(p);
    b.max_W = b.max_W.cwiseMax(p);
    ++b.end;
    elements_.push_back(e);
    x_.push_back(p.x());
    y_.push_back(p.y());
    z_.push_back(p.z());
    normal_x_.push_back(static_cast<float>(e.normal_W.x()));
    normal_y_.push_back(static_cast<float>(e.normal_W.y()));
    normal_z_.push_back(static_cast<float>(e.normal_W.z()));
    backed_.push_back(OccupiedFaces(map, e.voxel));
    const auto near_m = static_cast<float>(std::max(0.0, e.d_star_m - eta_m)) - kSlack_m;
    const auto far_m = static_cast<float>(e.d_star_m + eta_m) + kSlack_m;
    near2_.push_back(near_m > 0 ? near_m * near_m : 0);
    far2_.push_back(far_m * far_m);
    far_worth_ = std::max(far_worth_, 0.5 * (1 - (e.d_star_m + eta_m) / window.range_max_m()));
  }
}

template <class Visit>
void InformationGain::ForEachNear(const Eigen::Vector3d& view_W, Visit&& visit) const {
  const Eigen::Vector3f v = view_W.cast<float>();
  const float reach = static_cast<float>(window_.range_max_m()) + kSlack_m;
  for (const Bucket& bucket : buckets_) {
    const Eigen::Vector3f off = v - v.cwiseMax(bucket.min_W).cwiseMin(bucket.max_W);
    if (off.squaredNorm() <= reach * reach) visit(bucket);
  }
}

Gain InformationGain::Evaluate(const Eigen::Vector3d& view_W) const {
  GainBound most;
  most.visible = static_cast<int>(elements_.size());
  return Evaluate(view_W, most, 0);
}

Gain InformationGain::Evaluate(const Eigen::Vector3d& view_W, const GainBound& bound, int visible_min) const {
  Gain gain;
  int can_be = bound.visible + bound.hidden;
  bool hopeless = false;
  ForEachNear(view_W, [&](const Bucket& bucket) {
    for (int i = bucket.begin; i < bucket.end && !hopeless; ++i) {
      const Element& e = elements_[i];
      const Eigen::Vector3d to = e.p_W - view_W;
      if (!window_.InFieldOfView(to)) continue;
      const double distance_m = to.norm();
      if (!window_.InRange(distance_m)) continue;
      const Sight sight = LookAt(map_, e, view_W, &clear_);
      if (sight.clear) {
        ++gain.visible;
        gain.sum += DistanceWorth(distance_m, e.d_star_m, eta_m_, window_.range_max_m()) *
                    ClearProbability(sight.unknown);
      } else {
        hopeless = --can_be < visible_min;
      }
    }
  });
  if (hopeless) gain.visible = -1;
  return gain;
}

GainBound InformationGain::Bound(const Eigen::Vector3d& view_W) const {
  const Eigen::Vector3f v = view_W.cast<float>();
  const float reach = static_cast<float>(window_.range_max_m()) + kSlack_m;
  const float least = std::max(0.0f, static_cast<float>(window_.range_min_m()) - kSlack_m);
  const float reach2 = reach * reach, least2 = least * least;
  const auto tan_min = static_cast<float>(window_.tan_min()), tan_max = static_cast<float>(window_.tan_max());
  const auto voxel = static_cast<float>(map_.grid().voxel_m());
  int visible = 0, near = 0, far = 0, covered = 0;
  ForEachNear(view_W, [&](const Bucket& bucket) {
    for (int i = bucket.begin; i < bucket.end; ++i) {
      const float dx = x_[i] - v.x(), dy = y_[i] - v.y(), dz = z_[i] - v.z();
      const float rho2 = dx * dx + dy * dy, d2 = rho2 + dz * dz;
      const float rho = std::sqrt(rho2);
      // The walk from the element begins along the longest axis; within the slack of a tie nothing is
      // certain.
      const float ax = std::abs(dx), ay = std::abs(dy), az = std::abs(dz);
      const int along_x = (ax > ay + kSlack_m) & (ax > az + kSlack_m);
      const int along_y = (ay > ax + kSlack_m) & (ay > az + kSlack_m);
      const int along_z = (az > ax + kSlack_m) & (az > ay + kSlack_m);
      const int first = (along_x << (dx < 0)) | (along_y << (2 + (dy < 0))) | (along_z << (4 + (dz < 0)));
      const int turned = normal_x_[i] * dx + normal_y_[i] * dy + normal_z_[i] * dz > kSlack_m;
      const int hidden = turned & ((backed_[i] & first) != 0) & (d2 > 4 * voxel * voxel);
      const int in_window = (d2 <= reach2) & (d2 >= least2) & (dz >= tan_min * rho - kSlack_m) &
                            (dz <= tan_max * rho + kSlack_m);
      const int in = in_window & (hidden ^ 1);
      covered += in_window & hidden;
      visible += in;
      near += in & (d2 < near2_[i]);
      far += in & (d2 > far2_[i]);
    }
  });
  return {(visible - near - far) + 0.5 * near + far_worth_ * far + 1e-6, visible, covered};
}

}  // namespace citrine::planner
