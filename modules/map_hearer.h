#pragma once

#include <memory>

#include "core/map/planning_map.h"
#include "core/quality/active_surface.h"
#include "modules/runtime/module.h"
#include "planner/path/reachable_set.h"
#include "planner/path/topological_grid.h"

namespace citrine {

/// Hears MAP_BLOCKS and MAP_SUMMARY and keeps the planning map that they say; modules of one process share
/// one. The base station decides on the same quantised map, so all agree.
class MapHearer {
 public:
  MapHearer(const MissionConfig& config, Bus& bus);
  ~MapHearer();

  /// Takes over what was said before this step; the first caller of a step does the work. @return whether the
  /// map changed
  bool Update(const Step& step);

  const PlanningMap& map() const;
  /// Its active surface elements, as of the map at present: once asked for, Update keeps them so. Always the
  /// same object.
  const ActiveSurface& Surface();
  /// Where a UAV can get through its free space, and how far it is: whoever asks brings them up to date
  /// first.
  std::shared_ptr<planner::ReachableSet> reachable();
  planner::TopologicalGrid& topological_grid();
  /// Version of the newest summary whose digest this map has, i.e. the base station's map is held whole; -1
  /// before one.
  std::int64_t map_version() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace citrine
