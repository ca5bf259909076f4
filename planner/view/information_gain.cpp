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
constexpr float kSlack_m = 1e-3f;  ///< by which float bounds are widened; far above their rounding

using Truths = decltype(__m256() < __m256());  ///< all bits or none, eight times

unsigned Bits(Truths truths) {
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(truths)));
}
__m256 Abs(__m256 a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a); }
__m256d Abs(__m256d a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
Truths Row(const std::vector<int>& row, int first) {
  Truths eight;
  std::memcpy(&eight, &row[first], sizeof eight);
  return eight;
}

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

}  // namespace

double DistanceWorth(double distance_m, double d_star_m, double eta_m, double range_max_m) {
  if (distance_m > range_max_m) return 0;
  if (std::abs(distance_m - d_star_m) < eta_m) return 1;
  return distance_m < d_star_m ? 0.5 : 0.5 * (1 - distance_m / range_max_m);
}

InformationGain::InformationGain(const PlanningMap& map, const std::vector<Element>& elements,
                                 const SensorWindow& window, double eta_m)
    : map_(map), window_(window), eta_m_(eta_m) {
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
    for (int axis = 0; axis < 3; ++axis) {
      p_W_[axis].push_back(e.p_W[axis]);
      position_[axis].push_back(p[axis]);
      normal_[axis].push_back(static_cast<float>(e.normal_W[axis]));
    }
    d_star_m_.push_back(e.d_star_m);
    backed_.push_back(FacesIn(VoxelState::kOccupied, map, e.voxel));
    clouded_.push_back(FacesIn(VoxelState::kUnknown, map, e.voxel));
    near_m_.push_back(static_cast<float>(e.d_star_m - eta_m) - kSlack_m);
    far_m_.push_back(static_cast<float>(e.d_star_m + eta_m) + kSlack_m);
  }
  const auto pad = [&](auto&... rows) { (rows.resize(elements_.size() + 8), ...); };
  for (int axis = 0; axis < 3; ++axis) pad(p_W_[axis], position_[axis], normal_[axis]);
  pad(d_star_m_, near_m_, far_m_, backed_, clouded_);  // so that the last can be read eight at a time
}

template <class Visit>
void InformationGain::ForEachNear(const Eigen::AlignedBox3f& views_W, Visit&& visit) const {
  const float reach = static_cast<float>(window_.range_max_m()) + kSlack_m;
  for (const Bucket& bucket : buckets_) {
    const Eigen::Vector3f off =
        (bucket.min_W - views_W.max()).cwiseMax(views_W.min() - bucket.max_W).cwiseMax(0);
    if (off.squaredNorm() <= reach * reach) visit(bucket);
  }
}

/// Eight elements as seen from the views in a box; sets are bits.
struct InformationGain::Eight {
  Truths in;                   ///< perhaps in range and field of view, and not hidden for certain
  Truths averted;              ///< turns its back to all views
  Truths sector;               ///< of the directions that it lies in: eight octants by three longest axes
  Truths clouded;              ///< something unknown lies in between for certain
  __m256 nearest2, farthest2;  ///< [m^2] bounds of the distance
};

/// A box of views.
struct InformationGain::Box {
  Eigen::Vector3f centre_W, half_m;
};

[[gnu::always_inline]] inline InformationGain::Eight InformationGain::SeenFrom(const Box& views,
                                                                               int i) const {
  const float reach = static_cast<float>(window_.range_max_m()) + kSlack_m;
  const float least = std::max(0.0f, static_cast<float>(window_.range_min_m()) - kSlack_m);
  const auto tan_min = static_cast<float>(window_.tan_min()), tan_max = static_cast<float>(window_.tan_max());
  const auto voxel = static_cast<float>(map_.grid().voxel_m());
  __m256 to[3], size[3], at_least[3], at_most[3];  // from the centre, and bounds of its size from any view
  Truths back[3];
  __m256 least_dot = _mm256_setzero_ps();
  for (int axis = 0; axis < 3; ++axis) {
    const float half = views.half_m[axis];
    to[axis] = _mm256_loadu_ps(&position_[axis][i]) - views.centre_W[axis];
    size[axis] = Abs(to[axis]);
    at_least[axis] = _mm256_max_ps(size[axis] - half, _mm256_setzero_ps());
    at_most[axis] = size[axis] + half;
    back[axis] = to[axis] < 0;
    const __m256 normal = _mm256_loadu_ps(&normal_[axis][i]);
    least_dot += normal * to[axis] - Abs(normal) * half;
  }
  const __m256 least_rho2 = at_least[0] * at_least[0] + at_least[1] * at_least[1];
  const __m256 most_rho2 = at_most[0] * at_most[0] + at_most[1] * at_most[1];
  const __m256 least_rho = _mm256_sqrt_ps(least_rho2), most_rho = _mm256_sqrt_ps(most_rho2);
  const __m256 nearest2 = least_rho2 + at_least[2] * at_least[2];
  const __m256 farthest2 = most_rho2 + at_most[2] * at_most[2];

  // The walk from the element begins along the longest axis; within the slack of a tie nothing is certain.
  Truths first{};
  for (int axis = 0; axis < 3; ++axis) {
    const __m256 others = _mm256_max_ps(at_most[(axis + 1) % 3], at_most[(axis + 2) % 3]);
    first |= (at_least[axis] > others + kSlack_m) & ((1 - back[axis]) << (2 * axis));
  }
  first &= nearest2 > 4 * voxel * voxel;
  const Truths hidden = (least_dot > kSlack_m) & ((Row(backed_, i) & first) != 0);
  const Truths in = (nearest2 <= reach * reach) & (farthest2 >= least * least) &
                    (to[2] + views.half_m.z() >= tan_min * (tan_min < 0 ? most_rho : least_rho) - kSlack_m) &
                    (to[2] - views.half_m.z() <= tan_max * (tan_max > 0 ? most_rho : least_rho) + kSlack_m) &
                    ~hidden;
  const Truths steep = (size[2] > size[0]) & (size[2] > size[1]);
  const Truths sector =
      ((back[0] & 1) | (back[1] & 2) | (back[2] & 4)) + ((steep & 16) | (~steep & (size[1] > size[0]) & 8));
  return {in, least_dot > 0, sector, (Row(clouded_, i) & first) != 0, nearest2, farthest2};
}

template <class Visit>
void InformationGain::ForEachEight(const Eigen::AlignedBox3d& views_W, Visit&& visit) const {
  const Eigen::AlignedBox3f box_W = views_W.cast<float>();
  const Box box{box_W.center(), box_W.sizes() / 2};
  Truths lane;
  for (int k = 0; k < 8; ++k) lane[k] = k;
  ForEachNear(box_W, [&](const Bucket& bucket) {
    for (int i = bucket.begin; i < bucket.end; i += 8) {
      Eight eight = SeenFrom(box, i);
      eight.in &= lane < bucket.end - i;
      if (Bits(eight.in)) visit(i, eight);
    }
  });
}

void InformationGain::AppendInWindow(const Eigen::Vector3d& view_W, std::vector<InWindow>& elements) const {
  const double range_m = window_.range_max_m();
  ForEachEight({view_W, view_W}, [&](int first, const Eight& eight) {
    for (int half = 0; half < 8; half += 4) {
      // As SensorWindow::Sees and DistanceWorth have it, to the bit.
      const int at = first + half;
      const __m256d x = _mm256_loadu_pd(&p_W_[0][at]) - view_W.x(),
                    y = _mm256_loadu_pd(&p_W_[1][at]) - view_W.y(),
                    z = _mm256_loadu_pd(&p_W_[2][at]) - view_W.z();
      const __m256d rho = _mm256_sqrt_pd(x * x + y * y), distance_m = _mm256_sqrt_pd(x * x + y * y + z * z);
      const __m256d d_star_m = _mm256_loadu_pd(&d_star_m_[at]);
      const auto sees = (z >= window_.tan_min() * rho) & (z <= window_.tan_max() * rho) &
                        (distance_m >= window_.range_min_m()) & (distance_m <= range_m);
      const __m256d far_worth = 0.5 * (1 - distance_m / range_m);
      __m256d worth = distance_m < d_star_m ? _mm256_set1_pd(0.5) : far_worth;
      worth = Abs(distance_m - d_star_m) < eta_m_ ? _mm256_set1_pd(1.0) : worth;
      unsigned in =
          Bits(eight.in) >> half & static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(sees)));
      for (; in; in &= in - 1) {
        const int k = std::countr_zero(in);
        elements.push_back({at + k, 1u << eight.sector[half + k], eight.averted[half + k] != 0, worth[k]});
      }
    }
  });
}

std::array<Sight, 8> InformationGain::Look(const std::array<int, 8>& elements,
                                           const Eigen::Vector3d& view_W) const {
  std::array<const Element*, 8> of;
  for (int k = 0; k < 8; ++k) of[k] = &elements_[elements[k]];
  return LookAtEight(map_, of, view_W);
}

Gain InformationGain::Evaluate(const Eigen::Vector3d& view_W) const {
  Gain gain;
  std::vector<InWindow> elements;
  AppendInWindow(view_W, elements);
  for (const InWindow& e : elements) {
    const Sight sight = LookAt(map_, elements_[e.element], view_W);
    gain.visible += sight.clear;
    gain.sum += e.worth * Visibility(sight);
  }
  return gain;
}

Gain InformationGain::Bound(const Eigen::AlignedBox3d& views_W) const {
  const auto range = static_cast<float>(window_.range_max_m());
  const auto one_look = static_cast<float>(ClearProbability(1));
  __m256 sums = _mm256_setzero_ps();
  int visible = 0;
  ForEachEight(views_W, [&](int i, const Eight& eight) {
    visible += std::popcount(Bits(eight.in));
    const __m256 nearest = _mm256_sqrt_ps(eight.nearest2), farthest = _mm256_sqrt_ps(eight.farthest2);
    const __m256 far_worth = 0.5f - 0.5f / range * (nearest - kSlack_m);
    __m256 worth = _mm256_set1_ps(1.0f);
    worth = farthest < _mm256_loadu_ps(&near_m_[i]) ? _mm256_set1_ps(0.5f) : worth;
    worth = nearest > _mm256_loadu_ps(&far_m_[i]) ? far_worth : worth;
    worth = eight.clouded ? one_look * worth : worth;
    sums += eight.in ? worth : _mm256_setzero_ps();
  });
  double sum = 0;
  for (int lane = 0; lane < 8; ++lane) sum += static_cast<double>(sums[lane]);
  return {sum * (1 + kSlack_m) + static_cast<double>(kSlack_m), visible};
}

}  // namespace citrine::planner
