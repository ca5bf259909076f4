#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/quality/active_surface.h"
#include "core/time.h"
#include "planner/view/elements.h"
#include "planner/view/view.h"

namespace citrine::planner {

/// What a planner remembers of elements that do not yield: which were looked at in vain, which nothing
/// reachable sees.
///
/// Given up: two looks, each of which should have settled the element, did not raise its weight; nor, where
/// something unknown is near it, change the classes of the 27 voxels around it. It comes back when one of
/// those classes changes, once: noise may make a class flicker for ever. Unreachable: no safe, connected pose
/// sees it with use; tested again once an unknown voxel within the sensor's range has become known.
class ElementMemory {
 public:
  ElementMemory(const VoxelGrid& grid, double range_max_m);

  /// Lets elements come back that the map's change speaks for.
  void Update(const PlanningMap& map, const ActiveSurface& surface);

  /// Whether the element is out of the set at present.
  bool Skips(std::uint32_t linear) const { return (flags_[linear] & (kGivenUp | kUnreachable)) != 0; }

  /// What an element looked like before a look at it.
  struct Before {
    std::uint32_t linear;
    std::uint8_t weight_code;
    std::uint64_t around;  ///< digest of the 27 classes
  };
  Before Note(const PlanningMap& map, std::uint32_t linear) const;

  /// Compares with what a look has changed, and counts it if nothing did.
  void Judge(const PlanningMap& map, const ActiveSurface& surface, const Before& before);
  int Attempts(std::uint32_t linear) const;

  /// Counts a goal for this element that was blocked or had no way; after three it is given up.
  void CountBlocked(const PlanningMap& map, std::uint32_t linear);

  /// Takes an element out that has been looked at in vain.
  void GiveUp(const PlanningMap& map, std::uint32_t linear);
  void MarkUnreachable(std::uint32_t linear, std::int64_t revision);
  /// Puts all verdicts older than a map revision up for a new test. @return how many
  int RetestBefore(std::int64_t revision);

  /// The last view found off the normal.
  const View* Fallback(std::uint32_t linear) const;
  void RememberFallback(const View& view) { RecordOf(view.element).fallback = view; }

  int given_up() const { return given_up_; }
  int unreachable() const { return unreachable_; }

 private:
  enum Flag : std::uint8_t { kGivenUp = 1, kUnreachable = 2, kRecorded = 4 };
  struct Record {
    std::uint32_t linear = 0;
    int attempts = 0, blocked = 0, returns = 0;
    std::uint64_t around = 0;  ///< when it was given up
    std::int64_t tested = 0;   ///< map revision of the verdict "unreachable"
    std::optional<View> fallback;
  };
  std::uint64_t Around(const PlanningMap& map, std::uint32_t linear) const;
  /// Begins it if there is none.
  Record& RecordOf(std::uint32_t linear);
  void Forget(std::size_t record);
  void SpreadDiscoveries(const ActiveSurface& surface);

  VoxelGrid grid_;
  int reach_blocks_;
  std::vector<std::uint8_t> flags_;
  std::vector<Record> records_;
  std::map<std::uint32_t, std::size_t> record_of_;  ///< by voxel, index in `records_`
  std::vector<std::int32_t> near_discovery_;        ///< by block: newest discovery within range
  std::int64_t spread_ = 0;
  int given_up_ = 0, unreachable_ = 0;
};

}  // namespace citrine::planner
