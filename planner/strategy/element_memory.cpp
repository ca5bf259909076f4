#include "planner/strategy/element_memory.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace citrine::planner {

namespace {
constexpr int kAttemptsMax = 2;
constexpr int kBlockedMax = 3;
constexpr int kReturnsMax = 1;
}  // namespace

ElementMemory::ElementMemory(const VoxelGrid& grid, double range_max_m)
    : grid_(grid),
      reach_blocks_(static_cast<int>(std::ceil(range_max_m / (kBlockSide * grid.voxel_m())))),
      flags_(grid.num_voxels()),
      near_discovery_(static_cast<std::size_t>(grid.num_blocks())) {}

std::uint64_t ElementMemory::Around(const PlanningMap& map, std::uint32_t linear) const {
  const VoxelIndex v = grid_.FromLinear(linear);
  std::uint64_t digits = 0;  // 27 classes to the base 3 fit in 43 bits
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const VoxelIndex n = v + VoxelIndex(x, y, z);
        digits =
            3 * digits + (grid_.Contains(n) ? static_cast<std::uint64_t>(map.state(grid_.Linear(n))) : 0);
      }
  return digits;
}

void ElementMemory::Update(const PlanningMap& map, const ActiveSurface& surface) {
  if (surface.last_discovery() > spread_) SpreadDiscoveries(surface);
  for (auto it = records_.begin(); it != records_.end();) {
    const std::uint32_t linear = it->first;
    Record& record = it->second;
    std::uint8_t& flags = flags_[linear];
    const bool settled = surface.At(linear) < SurfaceClass::kLqse;
    if ((flags & kUnreachable) &&
        (settled || near_discovery_[grid_.Block(grid_.FromLinear(linear))] > record.tested)) {
      flags &= static_cast<std::uint8_t>(~kUnreachable);
      --unreachable_;
    }
    if ((flags & kGivenUp) &&
        (settled || (record.returns < kReturnsMax && Around(map, linear) != record.around))) {
      flags &= static_cast<std::uint8_t>(~kGivenUp);
      --given_up_;
      ++record.returns;
      record.attempts = record.blocked = 0;
    }
    const bool forget = settled && record.returns == 0 && record.attempts == 0;
    it = forget ? records_.erase(it) : std::next(it);
  }
}

void ElementMemory::SpreadDiscoveries(const ActiveSurface& surface) {
  spread_ = surface.last_discovery();
  const Eigen::Vector3i& n = grid_.blocks();
  std::vector<std::int64_t> from(near_discovery_.size());
  for (int b = 0; b < grid_.num_blocks(); ++b) near_discovery_[b] = surface.discovered(b);
  const int strides[3] = {1, n.x(), n.x() * n.y()};
  for (int axis = 0; axis < 3; ++axis) {  // the maximum over a box, one axis after the other
    from.swap(near_discovery_);
    for (int b = 0; b < grid_.num_blocks(); ++b) {
      const int at = b / strides[axis] % n[axis];
      std::int64_t newest = 0;
      for (int k = std::max(-reach_blocks_, -at); k <= std::min(reach_blocks_, n[axis] - 1 - at); ++k)
        newest = std::max(newest, from[b + k * strides[axis]]);
      near_discovery_[b] = newest;
    }
  }
}

ElementMemory::Before ElementMemory::Note(const PlanningMap& map, std::uint32_t linear) const {
  return {linear, map.weight_code(linear), Around(map, linear)};
}

void ElementMemory::Judge(const PlanningMap& map, const ActiveSurface& surface, const Before& before) {
  const std::uint32_t linear = before.linear;
  if (surface.At(linear) < SurfaceClass::kLqse || (flags_[linear] & kGivenUp)) return;
  const bool incomplete = surface.At(linear) == SurfaceClass::kIse;
  if (map.weight_code(linear) > before.weight_code) return;
  if (incomplete && Around(map, linear) != before.around) return;
  Record& record = records_[linear];
  if (++record.attempts >= kAttemptsMax) GiveUp(map, linear);
}

int ElementMemory::Attempts(std::uint32_t linear) const {
  const auto it = records_.find(linear);
  return it == records_.end() ? 0 : it->second.attempts;
}

void ElementMemory::CountBlocked(const PlanningMap& map, std::uint32_t linear) {
  if (flags_[linear] & kGivenUp) return;
  Record& record = records_[linear];
  if (++record.blocked >= kBlockedMax) GiveUp(map, linear);
}

void ElementMemory::GiveUp(const PlanningMap& map, std::uint32_t linear) {
  if (flags_[linear] & kGivenUp) return;
  flags_[linear] |= kGivenUp;
  records_[linear].around = Around(map, linear);
  ++given_up_;
}

void ElementMemory::MarkUnreachable(std::uint32_t linear, std::int64_t revision) {
  records_[linear].tested = revision;
  if (flags_[linear] & kUnreachable) return;
  flags_[linear] |= kUnreachable;
  ++unreachable_;
}

int ElementMemory::RetestBefore(std::int64_t revision) {
  int count = 0;
  for (const auto& [linear, record] : records_) {
    if (!(flags_[linear] & kUnreachable) || record.tested >= revision) continue;
    flags_[linear] &= static_cast<std::uint8_t>(~kUnreachable);
    --unreachable_;
    ++count;
  }
  return count;
}

const View* ElementMemory::Fallback(std::uint32_t linear) const {
  const auto it = records_.find(linear);
  return it != records_.end() && it->second.fallback ? &*it->second.fallback : nullptr;
}

}  // namespace citrine::planner
