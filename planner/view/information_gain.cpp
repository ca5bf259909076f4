#include "planner/view/information_gain.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {
constexpr double kBucket_m = 3.0;
constexpr std::size_t kManyViews = 50;  ///< from which on looking for clear cells first pays
constexpr float kSlack_m = 1e-3f;       ///< by which float bounds are widened; far above their rounding
/// Bit a: the face neighbour in direction a of -x, +x, -y, +y, -z, +z is in a state.
int FacesIn(VoxelState state, const PlanningMap& map, const VoxelIndex& v) {
  int bits = 0;
  for (int direction = 0; direction < 6; ++direction) {
    VoxelIndex n = v;
    n[direction / 2] += direction % 2 ? 1 : -1;
    if (map.grid().Contains(n) && map.state(map.grid().Linear(n)) == state) bits |= 1 << direction;
  }
  return bits;
}

/// Eight octants of directions by three longest axes.
std::uint32_t SectorOf(const Eigen::Vector3d& to) {
  const int octant = (to.x() < 0) + 2 * (to.y() < 0) + 4 * (to.z() < 0);
  Eigen::Index longest;
  to.cwiseAbs().maxCoeff(&longest);
  return 1u << (octant + 8 * static_cast<int>(longest));
}

}  // namespace

double DistanceWorth(double distance_m, double d_star_m, double eta_m, double range_max_m) {
  if (distance_m > range_max_m) return 0;
  if (std::abs(distance_m - d_star_m) < eta_m) return 1;
  return distance_m < d_star_m ? 0.5 : 0.5 * (1 - distance_m / range_max_m);
}

InformationGain::InformationGain(const PlanningMap& map, const std::vector<Element>& elements,
                                 const SensorWindow& window, double eta_m, std::size_t views)
    : map_(map), window_(window), eta_m_(eta_m) {
  if (views >= kManyViews) clear_.emplace(map);
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
    backed_.push_back(FacesIn(VoxelState::kOccupied, map, e.voxel));
    clouded_.push_back(FacesIn(VoxelState::kUnknown, map, e.voxel));
    near_m_.push_back(static_cast<float>(e.d_star_m - eta_m) - kSlack_m);
    far_m_.push_back(static_cast<float>(e.d_star_m + eta_m) + kSlack_m);
  }
  for (std::vector<float>* row : {&x_, &y_, &z_, &normal_x_, &normal_y_, &normal_z_, &near_m_, &far_m_})
    row->resize(elements_.size() + 8);  // so that the last can be read eight at a time
  backed_.resize(elements_.size() + 8);
  clouded_.resize(elements_.size() + 8);
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

void InformationGain::AppendInWindow(const Eigen::Vector3d& view_W, std::vector<InWindow>& elements) const {
  ForEachNear(view_W, [&](const Bucket& bucket) {
    for (int i = bucket.begin; i < bucket.end; ++i) {
      const Element& e = elements_[i];
      const Eigen::Vector3d to = e.p_W - view_W;
      if (!window_.InFieldOfView(to)) continue;
      const double distance_m = to.norm();
      if (!window_.InRange(distance_m)) continue;
      elements.push_back({i, SectorOf(to), e.normal_W.dot(to) > 0,
                          DistanceWorth(distance_m, e.d_star_m, eta_m_, window_.range_max_m())});
    }
  });
}

Gain InformationGain::Evaluate(const Eigen::Vector3d& view_W) const {
  Gain gain;
  std::vector<InWindow> elements;
  AppendInWindow(view_W, elements);
  for (const InWindow& e : elements) {
    const Sight sight = Look(e, view_W);
    gain.visible += sight.clear;
    gain.sum += e.worth * Visibility(sight);
  }
  return gain;
}

/// Eight elements as seen from a view; sets are bits.
struct InformationGain::Eight {
  using Truths = decltype(__m256() < __m256());
  unsigned in;       ///< perhaps in range and field of view, and not hidden for certain
  Truths in_lanes;   ///< the same, by lane
  Truths clouded;    ///< something unknown lies in between for certain
  __m256 distance2;  ///< [m^2]
};

template <class Visit>
void InformationGain::ForEachEight(const Eigen::Vector3d& view_W, Visit&& visit) const {
  const Eigen::Vector3f v = view_W.cast<float>();
  const float reach = static_cast<float>(window_.range_max_m()) + kSlack_m;
  const float least = std::max(0.0f, static_cast<float>(window_.range_min_m()) - kSlack_m);
  const auto tan_min = static_cast<float>(window_.tan_min()), tan_max = static_cast<float>(window_.tan_max());
  const auto voxel = static_cast<float>(map_.grid().voxel_m());
  const auto bits = [](auto truth) {
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(truth)));
  };
  typename Eight::Truths lane;
  for (int k = 0; k < 8; ++k) lane[k] = k;
  const auto abs = [](__m256 a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a); };
  ForEachNear(view_W, [&](const Bucket& bucket) {
    for (int i = bucket.begin; i < bucket.end; i += 8) {
      const __m256 dx = _mm256_loadu_ps(&x_[i]) - v.x(), dy = _mm256_loadu_ps(&y_[i]) - v.y(),
                   dz = _mm256_loadu_ps(&z_[i]) - v.z();
      const __m256 rho2 = dx * dx + dy * dy, d2 = rho2 + dz * dz, rho = _mm256_sqrt_ps(rho2);
      // The walk from the element begins along the longest axis; within the slack of a tie nothing is
      // certain.
      const __m256 ax = abs(dx), ay = abs(dy), az = abs(dz);
      const auto along_x = (ax > ay + kSlack_m) & (ax > az + kSlack_m);
      const auto along_y = (ay > ax + kSlack_m) & (ay > az + kSlack_m);
      const auto along_z = (az > ax + kSlack_m) & (az > ay + kSlack_m);
      const auto back_x = dx < 0, back_y = dy < 0, back_z = dz < 0;
      const auto first =
          (along_x & (1 - back_x)) | (along_y & ((1 - back_y) << 2)) | (along_z & ((1 - back_z) << 4));
      const __m256 dot = _mm256_loadu_ps(&normal_x_[i]) * dx + _mm256_loadu_ps(&normal_y_[i]) * dy +
                         _mm256_loadu_ps(&normal_z_[i]) * dz;
      typename Eight::Truths backed, clouded;
      std::memcpy(&backed, &backed_[i], sizeof backed);
      std::memcpy(&clouded, &clouded_[i], sizeof clouded);
      const auto more_than_a_step = d2 > 4 * voxel * voxel;
      const auto hidden = (dot > kSlack_m) & ((backed & first) != 0) & more_than_a_step;
      const auto in = (d2 <= reach * reach) & (d2 >= least * least) & (dz >= tan_min * rho - kSlack_m) &
                      (dz <= tan_max * rho + kSlack_m) & ~hidden & (lane < bucket.end - i);
      if (bits(in)) visit(i, Eight{bits(in), in, ((clouded & first) != 0) & more_than_a_step, d2});
    }
  });
}

Gain InformationGain::Bound(const Eigen::Vector3d& view_W) const {
  const auto range = static_cast<float>(window_.range_max_m());
  const auto one_look = static_cast<float>(ClearProbability(1));
  __m256 sums = _mm256_setzero_ps();
  int visible = 0;
  ForEachEight(view_W, [&](int i, const Eight& eight) {
    visible += std::popcount(eight.in);
    const __m256 distance = _mm256_sqrt_ps(eight.distance2);
    const __m256 far_worth = 0.5f - 0.5f / range * (distance - kSlack_m);
    __m256 worth = _mm256_set1_ps(1.0f);
    worth = distance < _mm256_loadu_ps(&near_m_[i]) ? _mm256_set1_ps(0.5f) : worth;
    worth = distance > _mm256_loadu_ps(&far_m_[i]) ? far_worth : worth;
    worth = eight.clouded ? one_look * worth : worth;
    sums += eight.in_lanes ? worth : _mm256_setzero_ps();
  });
  double sum = 0;
  for (int lane = 0; lane < 8; ++lane) sum += static_cast<double>(sums[lane]);
  return {sum * (1 + kSlack_m) + static_cast<double>(kSlack_m), visible};
}

}  // namespace citrine::planner
