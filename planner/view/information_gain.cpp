#include "planner/view/information_gain.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

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
    : map_(map),
      window_(window),
      eta_m_(eta_m),
      clear_(map),
      without_occupied_(map, ClearCells::Of::kEmptyAndUnknown) {
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
  for (std::vector<float>* row : {&x_, &y_, &z_, &normal_x_, &normal_y_, &normal_z_, &near2_, &far2_})
    row->resize(elements_.size() + 8);  // so that the last can be read eight at a time
  backed_.resize(elements_.size() + 8);
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
  Gain gain;
  ForEachNear(view_W, [&](const Bucket& bucket) {
    for (int i = bucket.begin; i < bucket.end; ++i) {
      const Element& e = elements_[i];
      const Eigen::Vector3d to = e.p_W - view_W;
      if (!window_.InFieldOfView(to)) continue;
      const double distance_m = to.norm();
      if (!window_.InRange(distance_m)) continue;
      const Sight sight = LookAt(map_, e, view_W, &clear_);
      if (!sight.clear) continue;
      ++gain.visible;
      gain.sum += DistanceWorth(distance_m, e.d_star_m, eta_m_, window_.range_max_m()) *
                  ClearProbability(sight.unknown);
    }
  });
  return gain;
}

/// Eight elements as seen from a view; sets are bits.
struct InformationGain::Eight {
  unsigned in = 0;       ///< perhaps in range and field of view, and not hidden for certain
  unsigned covered = 0;  ///< the same, and hidden for certain
  __m256 distance2 = _mm256_setzero_ps();
  __m256i sector = _mm256_setzero_si256();
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
      std::remove_const_t<decltype(along_x)> backed;
      std::memcpy(&backed, &backed_[i], sizeof backed);
      const auto hidden = (dot > kSlack_m) & ((backed & first) != 0) & (d2 > 4 * voxel * voxel);
      const auto in_window = (d2 <= reach * reach) & (d2 >= least * least) &
                             (dz >= tan_min * rho - kSlack_m) & (dz <= tan_max * rho + kSlack_m);
      const unsigned window = bits(in_window) & (0xffu >> std::max(0, i + 8 - bucket.end)),
                     covered = bits(hidden);
      if (!window) continue;
      const auto longest = ((ay > ax) & 8) + ((az > ax) & (az > ay) & 8);
      const auto sector = longest - back_x - 2 * back_y - 4 * back_z;
      visit(i, Eight{window & ~covered, window & covered, d2, reinterpret_cast<__m256i>(sector)});
    }
  });
}

int InformationGain::CountVisible(const Eigen::Vector3d& view_W, const GainBound& bound, int visible_min,
                                  Hunch& hunch) const {
  struct Candidate {
    int element;
    std::uint32_t sector;
  };
  std::vector<Candidate> order(static_cast<std::size_t>(bound.visible) + 8);
  std::size_t first = 0,
              last =
                  static_cast<std::size_t>(bound.visible);  // suspects from the front, others from the back
  alignas(32) std::array<std::uint32_t, 8> sector;
  ForEachEight(view_W, [&](int i, const Eight& eight) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(sector.data()), eight.sector);
    for (unsigned left = eight.in; left; left &= left - 1) {
      const int k = std::countr_zero(left);
      const Candidate candidate{i + k, 1u << sector[k]};
      order[hunch[i + k] & candidate.sector ? first++ : --last] = candidate;
    }
  });
  int can_be = bound.visible;
  for (std::size_t at = 0; at < static_cast<std::size_t>(bound.visible); ++at) {
    const auto [element, from] = order[at];
    const Element& e = elements_[element];
    if (window_.Sees(e.p_W - view_W) && !Occluded(map_, e, view_W, without_occupied_)) {
      hunch[element] &= ~from;
      continue;
    }
    hunch[element] |= from;
    if (--can_be < visible_min) return -1;
  }
  return can_be;
}

GainBound InformationGain::Bound(const Eigen::Vector3d& view_W) const {
  int visible = 0, near = 0, far = 0, covered = 0;
  ForEachEight(view_W, [&](int i, const Eight& eight) {
    const auto among = [&](auto truth) {
      return std::popcount(eight.in &
                           static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(truth))));
    };
    visible += std::popcount(eight.in);
    covered += std::popcount(eight.covered);
    near += among(eight.distance2 < _mm256_loadu_ps(&near2_[i]));
    far += among(eight.distance2 > _mm256_loadu_ps(&far2_[i]));
  });
  return {(visible - near - far) + 0.5 * near + far_worth_ * far + 1e-6, visible, covered};
}

}  // namespace citrine::planner
