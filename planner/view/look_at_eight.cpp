#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
using Reals = __m256d;                          ///< of four rays
using Whole = decltype(__m256d() < __m256d());  ///< likewise; all bits or none where it is a truth

/// Four walks of LookAt, from elements to one view, abreast.
struct Four {
  Reals next[3], stride[3];
  Whole step[3], left[3], touching_until[3];
  Whole at, steps, in_front;
  Whole walking, hidden{}, unknown{};
};

bool Any(Whole truth) { return _mm256_movemask_pd(reinterpret_cast<Reals>(truth)) != 0; }

Four Begin(const VoxelGrid& grid, const Element* const* elements, const Eigen::Vector3d* const* views_W) {
  const std::int64_t strides[3] = {1, static_cast<std::int64_t>(grid.stride_y()),
                                   static_cast<std::int64_t>(grid.stride_z())};
  Four rays;
  rays.steps = Whole{};
  VoxelIndex ends[4];
  for (int k = 0; k < 4; ++k) ends[k] = grid.IndexOf(*views_W[k]);
  for (int axis = 0; axis < 3; ++axis) {
    Whole voxels;
    Reals along;
    for (int k = 0; k < 4; ++k) {
      voxels[k] = ends[k][axis] - elements[k]->voxel[axis];
      along[k] = std::abs((*views_W[k])[axis] - elements[k]->p_W[axis]);
    }
    const Whole forward = voxels > 0;
    rays.left[axis] = forward ? voxels : -voxels;
    rays.steps += rays.left[axis];
    rays.touching_until[axis] = rays.left[axis] - 2;
    rays.step[axis] = forward ? Whole{} + strides[axis] : Whole{} - strides[axis];
    rays.stride[axis] = rays.left[axis] > 0 ? grid.voxel_m() / along : Reals{} + kNever;
    rays.next[axis] = rays.left[axis] > 0 ? 0.5 * rays.stride[axis] : Reals{} + kNever;
  }
  for (int k = 0; k < 4; ++k) {
    rays.at[k] = elements[k]->linear;
    rays.in_front[k] = elements[k]->normal_W.dot(*views_W[k] - elements[k]->p_W) > 0 ? -1 : 0;
    rays.hidden[k] = grid.Contains(ends[k]) ? 0 : -1;
  }
  rays.walking = (rays.steps > 1) & ~rays.hidden;
  return rays;
}

/// One voxel further, the i-th.
void Advance(Four& rays, const std::uint8_t* states, int i) {
  const Reals x = rays.next[0], y = rays.next[1], z = rays.next[2];
  Whole along[3];
  along[0] = (x <= y) & (x <= z);
  along[1] = (x > y) & (y <= z);
  along[2] = ~(along[0] | along[1]);
  rays.at +=
      rays.walking & ((along[0] & rays.step[0]) | (along[1] & rays.step[1]) | (along[2] & rays.step[2]));
  for (int axis = 0; axis < 3; ++axis) {
    rays.left[axis] += along[axis];
    const Reals further =
        rays.next[axis] + reinterpret_cast<Reals>(along[axis] & reinterpret_cast<Whole>(rays.stride[axis]));
    rays.next[axis] = rays.left[axis] == 0 ? Reals{} + kNever : further;
  }
  const Whole eight = reinterpret_cast<Whole>(_mm256_i64gather_epi64(
      reinterpret_cast<const long long*>(states), reinterpret_cast<__m256i>(rays.at & ~7LL), 1));
  const Whole state = reinterpret_cast<Whole>(_mm256_srlv_epi64(
                          reinterpret_cast<__m256i>(eight), reinterpret_cast<__m256i>((rays.at & 7) << 3))) &
                      0xff;
  Whole hidden = rays.walking & (state == static_cast<long long>(VoxelState::kOccupied));
  if (i <= 3) {
    const Whole touching = (rays.left[0] > rays.touching_until[0]) & (rays.left[1] > rays.touching_until[1]) &
                           (rays.left[2] > rays.touching_until[2]);
    hidden &= ~(touching & rays.in_front);
  }
  rays.unknown -= rays.walking & (state == static_cast<long long>(VoxelState::kUnknown));
  rays.hidden |= hidden;
  rays.walking &= ~hidden & (rays.steps > i + 1);
}

}  // namespace

std::array<Sight, 8> LookAtEight(const PlanningMap& map, const std::array<const Element*, 8>& elements,
                                 const std::array<const Eigen::Vector3d*, 8>& views_W) {
  Four first = Begin(map.grid(), &elements[0], &views_W[0]);
  Four second = Begin(map.grid(), &elements[4], &views_W[4]);
  const std::uint8_t* const states = map.states().data();
  for (int i = 1; Any(first.walking | second.walking); ++i) {
    Advance(first, states, i);
    Advance(second, states, i);
  }
  std::array<Sight, 8> sights;
  for (int k = 0; k < 4; ++k) {
    sights[k] = {first.hidden[k] == 0, static_cast<int>(first.unknown[k])};
    sights[k + 4] = {second.hidden[k] == 0, static_cast<int>(second.unknown[k])};
  }
  return sights;
}

}  // namespace citrine::planner
