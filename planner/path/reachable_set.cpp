#include "planner/path/reachable_set.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/parallel_for.h"

namespace citrine::planner {

namespace {

constexpr double kEscape_m = 3.0;
constexpr int kParts = 4;  ///< that threads take, of the reading of safe voxels

/// All bits of `open` that a run of ones connects to `seeds` (Kogge & Stone's parallel prefix, both ways).
std::uint64_t FillRuns(std::uint64_t seeds, std::uint64_t open) {
  std::uint64_t up = seeds, down = seeds, open_up = open, open_down = open;
  for (int shift = 1; shift < 64; shift *= 2) {
    up |= open_up & (up << shift);
    open_up &= open_up << shift;
    down |= open_down & (down >> shift);
    open_down &= open_down >> shift;
  }
  return up | down;
}

}  // namespace

ReachableSet::ReachableSet(const PlanningMap& map, const VehicleLimits& limits, double margin_m,
                           Unknown unknown)
    : space_(map, limits, margin_m, unknown),
      words_((static_cast<std::size_t>(map.grid().voxels().x()) + 63) / 64) {
  const std::size_t rows = static_cast<std::size_t>(map.grid().voxels().y()) * map.grid().voxels().z();
  safe_.assign(words_ * rows, 0);
  reached_.assign(words_ * rows, 0);
  seeds_.assign(words_ * rows, 0);
}

void ReachableSet::Update(const Eigen::Vector3d& from_W) {
  const bool map_is_new = revision_ != space_.map().revision();
  const std::optional<VoxelIndex> from = space_.NearestSafeVoxel(from_W, kEscape_m);
  if (!map_is_new && (from ? Reaches(*from) : !origin_)) return;
  if (map_is_new) ReadSafeVoxels();
  revision_ = space_.map().revision();
  std::fill(reached_.begin(), reached_.end(), 0);
  origin_ = from;
  if (from) Flood(*from);
}

void ReachableSet::ReadSafeVoxels() {
  const VoxelGrid& grid = space_.map().grid();
  const VoxelIndex lo = grid.inside_min(), hi = grid.inside_max();
  ParallelFor(hi.z() - lo.z(), kParts, [&](int from, int to) {
    for (int z = lo.z() + from; z < lo.z() + to; ++z)
      for (int y = lo.y(); y < hi.y(); ++y) {
        const std::size_t row = Row(y, z), first = grid.Linear({0, y, z});
        for (std::size_t word = 0; word < words_; ++word) {
          const int base = static_cast<int>(word) * 64;
          const int begin = std::clamp(lo.x() - base, 0, 64), end = std::clamp(hi.x() - base, 0, 64);
          safe_[row + word] =
              begin < end ? space_.SafeVoxels(first + static_cast<std::size_t>(base), begin, end) : 0;
        }
      }
  });
}

void ReachableSet::Flood(const VoxelIndex& origin) {
  const std::size_t stride_y = words_;
  const std::size_t stride_z = words_ * static_cast<std::size_t>(space_.map().grid().voxels().y());
  queue_.clear();
  const auto seed = [&](std::size_t word, std::uint64_t bits) {
    bits &= safe_[word] & ~reached_[word];
    if (!bits) return;
    if (!seeds_[word]) queue_.push_back(static_cast<std::uint32_t>(word));
    seeds_[word] |= bits;
  };
  seed(Row(origin.y(), origin.z()) + static_cast<std::size_t>(origin.x() >> 6), 1ULL << (origin.x() & 63));
  while (!queue_.empty()) {
    const std::size_t word = queue_.back();
    queue_.pop_back();
    const std::uint64_t fresh = FillRuns(seeds_[word], safe_[word]) & ~reached_[word];
    seeds_[word] = 0;
    if (!fresh) continue;
    reached_[word] |= fresh;
    const std::size_t in_row = word % words_;
    if (in_row > 0) seed(word - 1, (fresh & 1) << 63);
    if (in_row + 1 < words_) seed(word + 1, fresh >> 63);
    // Voxels inside the volume never lie on the grid's faces: the margin is at least one voxel wide.
    if (word >= stride_y) seed(word - stride_y, fresh);
    if (word + stride_y < safe_.size()) seed(word + stride_y, fresh);
    if (word >= stride_z) seed(word - stride_z, fresh);
    if (word + stride_z < safe_.size()) seed(word + stride_z, fresh);
  }
}

std::optional<VoxelIndex> ReachableSet::Nearest(const Eigen::Vector3d& p_W, double reach_m) const {
  const VoxelGrid& grid = space_.map().grid();
  const int reach = static_cast<int>(std::ceil(reach_m / grid.voxel_m()));
  const VoxelIndex centre = grid.IndexOf(p_W);
  const VoxelIndex lo = (centre.array() - reach).max(grid.inside_min().array());
  const VoxelIndex hi = (centre.array() + reach + 1).min(grid.inside_max().array());
  std::optional<VoxelIndex> nearest;
  double best = reach_m * reach_m;
  for (int z = lo.z(); z < hi.z(); ++z)
    for (int y = lo.y(); y < hi.y(); ++y)
      for (int x = lo.x(); x < hi.x(); ++x) {
        const VoxelIndex v(x, y, z);
        if (!ReachesInside(v)) continue;
        const double d2 = (grid.Centre(v) - p_W).squaredNorm();
        if (d2 < best) best = d2, nearest = v;
      }
  return nearest;
}

std::size_t ReachableSet::size() const {
  std::size_t count = 0;
  for (const std::uint64_t word : reached_) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

}  // namespace citrine::planner
