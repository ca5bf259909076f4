#include "core/map/distance_field.h"

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/map/dirty_boxes.h"

namespace citrine {
namespace {

/// Squared distances side by side in an AVX2 register: bytes where the radius lets them fit, else u16.
template <class T>
struct Squares {
  static constexpr int kLanes = 32 / sizeof(T);
  static __m256i Set(int value) {
    if constexpr (sizeof(T) == 1) return _mm256_set1_epi8(static_cast<char>(value));
    return _mm256_set1_epi16(static_cast<short>(value));
  }
  static __m256i Min(__m256i a, __m256i b) {
    return sizeof(T) == 1 ? _mm256_min_epu8(a, b) : _mm256_min_epu16(a, b);
  }
  static __m256i Add(__m256i a, __m256i b) {
    return sizeof(T) == 1 ? _mm256_adds_epu8(a, b) : _mm256_adds_epu16(a, b);
  }
  static bool NoneAbove(__m256i a, __m256i limit) {
    return _mm256_movemask_epi8(sizeof(T) == 1 ? _mm256_cmpeq_epi8(_mm256_max_epu8(a, limit), limit)
                                               : _mm256_cmpeq_epi16(_mm256_max_epu16(a, limit), limit)) == -1;
  }
};

constexpr int kLargestByteRadius = 15;

DirtyBox Grow(const DirtyBox& box, int by, const VoxelGrid& grid) {
  return {(box.min.array() - by).max(0), (box.max.array() + by).min(grid.voxels().array())};
}

/// min over |k| < radius of in[at + k] + k^2 in all lanes; rows lie `stride` apart, and `below`, `above` of
/// them exist.
template <class T>
__m256i LowerEnvelope(const T* at, std::ptrdiff_t stride, int below, int above, int radius) {
  const auto load = [&](int k) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at + k * stride));
  };
  __m256i best = load(0);
  for (int k = 1; k < radius; ++k) {
    const __m256i square = Squares<T>::Set(k * k);
    // Nothing k rows away can be nearer than k: once every lane is, the minimum is found.
    if (Squares<T>::NoneAbove(best, square)) break;
    if (k <= below) best = Squares<T>::Min(best, Squares<T>::Add(load(-k), square));
    if (k <= above) best = Squares<T>::Min(best, Squares<T>::Add(load(k), square));
  }
  return best;
}

/// Squared distance along x to the nearest site of the row, capped; zero beyond `count`. @param first  x of
/// out[0] @param near  room for 2 `radius` + `width` lanes @return whether there is a site within the radius
template <class T>
bool DistanceAlongRow(const std::uint8_t* is_site, int first, int count, int row_size, int radius, int width,
                      std::vector<T>& near, T* out) {
  const int begin = std::max(0, first - radius), end = std::min(row_size, first + count + radius);
  std::uint8_t any = 0;
  for (int x = begin; x < end; ++x) any |= is_site[x];
  const T cap = static_cast<T>(radius * radius);
  if (!any) {
    std::fill_n(out, count, cap);
    std::fill(out + count, out + width, T{0});
    return false;
  }
  std::fill(near.begin(), near.end(), cap);
  T* const at_first = &near[static_cast<std::size_t>(radius)];
  for (int x = begin; x < end; ++x) at_first[x - first] = is_site[x] ? T{0} : cap;
  for (int x = 0; x < width; x += Squares<T>::kLanes)
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + x),
                        LowerEnvelope(at_first + x, 1, radius, radius, radius));
  std::fill(out + count, out + width, T{0});
  return true;
}

/// Which of the layers have one with a site fewer than `radius` away.
std::vector<std::uint8_t> NearSites(const std::vector<std::uint8_t>& has_site, int radius) {
  const int count = static_cast<int>(has_site.size());
  std::vector<std::uint8_t> near(has_site.size(), 0);
  for (int i = 0, last = -radius; i < count; ++i) {
    if (has_site[i]) last = i;
    near[i] = i - last < radius;
  }
  for (int i = count, next = count + radius; i-- > 0;) {
    if (has_site[i]) next = i;
    near[i] |= next - i < radius;
  }
  return near;
}

/// DistanceField::Update, on numbers of one kind.
template <class T>
void UpdateAs(const VoxelGrid& grid, int radius_vox, const std::vector<std::uint8_t>& is_site,
              const DirtyBox& changed, std::vector<std::uint16_t>& squared) {
  constexpr int kLanes = Squares<T>::kLanes;
  const DirtyBox out = Grow(changed, radius_vox - 1, grid);
  const DirtyBox in = Grow(out, radius_vox - 1, grid);
  const Eigen::Vector3i size = out.max - out.min, in_size = in.max - in.min;
  const int width = (size.x() + kLanes - 1) / kLanes * kLanes;
  const int in_y = in_size.y(), in_z = in_size.z(), out_y = size.y();

  const T cap_vox2 = static_cast<T>(radius_vox * radius_vox);
  std::vector<T> along_x(static_cast<std::size_t>(width) * in_y * in_z);
  std::vector<T> along_xy(static_cast<std::size_t>(width) * out_y * in_z, cap_vox2);
  std::vector<T> near(static_cast<std::size_t>(2 * radius_vox + width));
  std::vector<std::uint8_t> row_has_site(static_cast<std::size_t>(in_y));
  std::vector<std::uint8_t> plane_has_site(static_cast<std::size_t>(in_z));
  const int skipped_y = out.min.y() - in.min.y();
  for (int z = 0; z < in_z; ++z) {
    for (int y = 0; y < in_y; ++y) {
      const std::size_t row = grid.Linear({0, in.min.y() + y, in.min.z() + z});
      row_has_site[y] = DistanceAlongRow(
          &is_site[row], out.min.x(), size.x(), grid.voxels().x(), radius_vox, width, near,
          &along_x[static_cast<std::size_t>(width) * (y + static_cast<std::size_t>(in_y) * z)]);
      plane_has_site[z] |= row_has_site[y];
    }
    if (!plane_has_site[z]) continue;
    const std::vector<std::uint8_t> near_row = NearSites(row_has_site, radius_vox);
    for (int y = 0; y < out_y; ++y) {
      const int from = y + skipped_y;
      if (!near_row[from]) continue;
      for (int x = 0; x < width; x += kLanes) {
        const __m256i best = LowerEnvelope(
            &along_x[x + static_cast<std::size_t>(width) * (from + static_cast<std::size_t>(in_y) * z)],
            width, from, in_y - 1 - from, radius_vox);
        _mm256_storeu_si256(
            reinterpret_cast<__m256i*>(
                &along_xy[x + static_cast<std::size_t>(width) * (y + static_cast<std::size_t>(out_y) * z)]),
            best);
      }
    }
  }

  const std::vector<std::uint8_t> near_plane = NearSites(plane_has_site, radius_vox);
  const __m256i cap = Squares<T>::Set(radius_vox * radius_vox);
  const std::ptrdiff_t plane = static_cast<std::ptrdiff_t>(width) * out_y;
  const int skipped_z = out.min.z() - in.min.z();
  alignas(32) T lanes[kLanes];
  for (int z = 0; z < size.z(); ++z)
    for (int y = 0; y < out_y; ++y) {
      const int from = z + skipped_z;
      const std::size_t row = grid.Linear({out.min.x(), out.min.y() + y, out.min.z() + z});
      if (!near_plane[from]) {
        std::fill_n(&squared[row], size.x(), static_cast<std::uint16_t>(cap_vox2));
        continue;
      }
      for (int x = 0; x < width; x += kLanes) {
        const __m256i best = LowerEnvelope(&along_xy[x + static_cast<std::size_t>(width) * y + plane * from],
                                           plane, from, in_z - 1 - from, radius_vox);
        _mm256_store_si256(reinterpret_cast<__m256i*>(lanes), Squares<T>::Min(best, cap));
        std::copy_n(lanes, std::min(kLanes, size.x() - x), &squared[row + x]);
      }
    }
}

}  // namespace

DistanceField::DistanceField(const VoxelGrid& grid, int radius_vox, double caution_m)
    : grid_(grid), radius_vox_(radius_vox), caution_m_(caution_m), metres_(radius_vox * radius_vox + 1) {
  if (radius_vox < 1 || radius_vox > 181)
    throw std::invalid_argument("a distance field reaches 1..181 voxels");
  squared_.assign(grid.num_voxels(), static_cast<std::uint16_t>(radius_vox * radius_vox));
  for (std::size_t i = 0; i < metres_.size(); ++i)
    metres_[i] = static_cast<float>(std::sqrt(static_cast<double>(i)) * grid.voxel_m() - caution_m);
}

void DistanceField::Update(const std::vector<std::uint8_t>& is_site, const VoxelIndex& min,
                           const VoxelIndex& max) {
  if ((min.array() >= max.array()).any()) return;
  if (radius_vox_ <= kLargestByteRadius)
    UpdateAs<std::uint8_t>(grid_, radius_vox_, is_site, {min, max}, squared_);
  else
    UpdateAs<std::uint16_t>(grid_, radius_vox_, is_site, {min, max}, squared_);
}

double DistanceField::Interpolate(const Eigen::Vector3d& p_W, Eigen::Vector3d* gradient) const {
  const Eigen::Vector3d in_voxels =
      (p_W - grid_.origin_W()) / grid_.voxel_m() - Eigen::Vector3d::Constant(0.5);
  std::size_t low[3], high[3];
  double share[3];
  bool outside[3];
  const std::size_t stride[3] = {1, grid_.stride_y(), grid_.stride_z()};
  for (int axis = 0; axis < 3; ++axis) {
    const double top = grid_.voxels()[axis] - 1;
    outside[axis] = !(in_voxels[axis] >= 0 && in_voxels[axis] <= top);
    const double x = std::clamp(in_voxels[axis], 0.0, top);
    const double floor = std::min(std::floor(x), std::max(top - 1, 0.0));
    share[axis] = x - floor;
    low[axis] = stride[axis] * static_cast<std::size_t>(floor);
    high[axis] = low[axis] + (top > 0 ? stride[axis] : 0);
  }
  const auto at = [&](std::size_t x, std::size_t y, std::size_t z) {
    return static_cast<double>(At(x + y + z));
  };
  const auto mix = [](double a, double b, double s) { return a + (b - a) * s; };
  const double c000 = at(low[0], low[1], low[2]), c100 = at(high[0], low[1], low[2]);
  const double c010 = at(low[0], high[1], low[2]), c110 = at(high[0], high[1], low[2]);
  const double c001 = at(low[0], low[1], high[2]), c101 = at(high[0], low[1], high[2]);
  const double c011 = at(low[0], high[1], high[2]), c111 = at(high[0], high[1], high[2]);
  const double y0z0 = mix(c000, c100, share[0]), y1z0 = mix(c010, c110, share[0]);
  const double y0z1 = mix(c001, c101, share[0]), y1z1 = mix(c011, c111, share[0]);
  const double z0 = mix(y0z0, y1z0, share[1]), z1 = mix(y0z1, y1z1, share[1]);
  if (gradient) {
    const double per_m = 1.0 / grid_.voxel_m();
    (*gradient)[0] =
        mix(mix(c100 - c000, c110 - c010, share[1]), mix(c101 - c001, c111 - c011, share[1]), share[2]);
    (*gradient)[1] = mix(y1z0 - y0z0, y1z1 - y0z1, share[2]);
    (*gradient)[2] = z1 - z0;
    for (int axis = 0; axis < 3; ++axis) (*gradient)[axis] *= outside[axis] ? 0.0 : per_m;
  }
  return mix(z0, z1, share[2]);
}

}  // namespace citrine
