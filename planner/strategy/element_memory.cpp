#include "planner/strategy/element_memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

ElementMemory::Record& ElementMemory::RecordOf(std::uint32_t linear) {
  const auto [at, is_new] = record_of_.try_emplace(linear, records_.size());
  if (is_new) {
    records_.emplace_back().linear = linear;
    flags_[linear] |= kRecorded;
  }
  return records_[at->second];
}

void ElementMemory::Forget(std::size_t record) {
  const std::uint32_t linear = records_[record].linear;
  flags_[linear] &= static_cast<std::uint8_t>(~kRecorded);
  record_of_.erase(linear);
  if (record + 1 < records_.size()) {
    records_[record] = std::move(records_.back());
    record_of_[records_[record].linear] = record;
  }
  records_.pop_back();
}

void ElementMemory::Update(const PlanningMap& map, const ActiveSurface& surface) {
  if (unreachable_ > 0 && surface.last_discovery() > spread_) SpreadDiscoveries(surface);
  for (std::size_t i = records_.size(); i-- > 0;) {
    Record& record = records_[i];
    const std::uint32_t linear = record.linear;
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
    if (settled && record.returns == 0 && record.attempts == 0) Forget(i);
  }
}

/// The maximum over a box of blocks, one axis after the other. Along each the blocks lie in layers, `inner`
/// side by side.
void ElementMemory::SpreadDiscoveries(const ActiveSurface& surface) {
  spread_ = surface.last_discovery();
  const Eigen::Vector3i& n = grid_.blocks();
  const int num_blocks = grid_.num_blocks();
  for (int b = 0; b < num_blocks; ++b) near_discovery_[b] = static_cast<std::int32_t>(surface.discovered(b));
  std::vector<std::int32_t> from;
  for (int axis = 0, inner = 1; axis < 3; inner *= n[axis++]) {
    from = near_discovery_;
    const int reach = std::min(reach_blocks_, n[axis] - 1);
    for (int first = 0; first < num_blocks; first += inner * n[axis])
      for (int k = -reach; k <= reach; ++k) {
        const int begin = first + std::max(0, -k) * inner;
        const int end = first + (n[axis] - std::max(0, k)) * inner;
        for (int b = begin; b < end; ++b)
          near_discovery_[b] = std::max(near_discovery_[b], from[b + k * inner]);
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
  Record& record = RecordOf(linear);
  if (++record.attempts >= kAttemptsMax) GiveUp(map, linear);
}

int ElementMemory::Attempts(std::uint32_t linear) const {
  return flags_[linear] & kRecorded ? records_[record_of_.at(linear)].attempts : 0;
}

void ElementMemory::CountBlocked(const PlanningMap& map, std::uint32_t linear) {
  if (flags_[linear] & kGivenUp) return;
  Record& record = RecordOf(linear);
  if (++record.blocked >= kBlockedMax) GiveUp(map, linear);
}

void ElementMemory::GiveUp(const PlanningMap& map, std::uint32_t linear) {
  if (flags_[linear] & kGivenUp) return;
  flags_[linear] |= kGivenUp;
  RecordOf(linear).around = Around(map, linear);
  ++given_up_;
}

void ElementMemory::MarkUnreachable(std::uint32_t linear, std::int64_t revision) {
  RecordOf(linear).tested = revision;
  if (flags_[linear] & kUnreachable) return;
  flags_[linear] |= kUnreachable;
  ++unreachable_;
}

int ElementMemory::RetestBefore(std::int64_t revision) {
  int count = 0;
  for (const Record& record : records_) {
    std::uint8_t& flags = flags_[record.linear];
    if (!(flags & kUnreachable) || record.tested >= revision) continue;
    flags &= static_cast<std::uint8_t>(~kUnreachable);
    --unreachable_;
    ++count;
  }
  return count;
}

const View* ElementMemory::Fallback(std::uint32_t linear) const {
  if (!(flags_[linear] & kRecorded)) return nullptr;
  const Record& record = records_[record_of_.at(linear)];
  return record.fallback ? &*record.fallback : nullptr;
}

}  // namespace citrine::planner
