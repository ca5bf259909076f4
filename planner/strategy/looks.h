#pragma once

#include <cstdint>
#include <vector>

#include "core/time.h"
#include "planner/strategy/element_memory.h"

namespace citrine::planner {

/// Looks at elements that should have settled them, until the map has had the time to say whether they did.
/// Meanwhile their elements count as seen: a UAV neither waits for the map at every view nor turns back to
/// what it has just seen.
class Looks {
 public:
  /// @param settle_s from a look until a map with its scan has certainly been said and heard
  explicit Looks(double settle_s) : settle_(FromSeconds(settle_s)) {}

  void Add(std::vector<ElementMemory::Before> elements, std::int64_t revision, Utime now);

  /// Judges the looks that are due: their time is over and the map has changed since. @return whether there
  /// were any
  bool Judge(const PlanningMap& map, const ActiveSurface& surface, Utime now, ElementMemory& memory);

  /// Adds the voxels of all elements under judgement.
  void AppendTo(std::vector<std::uint32_t>& voxels) const;
  bool empty() const { return looks_.empty(); }
  Utime settle_time() const { return settle_; }

 private:
  struct Look {
    std::vector<ElementMemory::Before> elements;
    std::int64_t revision;
    Utime at;
  };
  Utime settle_;
  std::vector<Look> looks_;
};

}  // namespace citrine::planner
