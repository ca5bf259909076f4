#pragma once

#include <vector>

#include "core/trajectory/trajectory.h"

namespace citrine::planner {

/// The pieces of a motion between two instants, exactly; before its start and after its end it stands still.
std::vector<TrajectorySegment> Cut(const Trajectory& trajectory, Utime from, Utime to);

/// A motion that follows `flown` from `now` until `at`, then `segments`.
Trajectory Splice(const Trajectory& flown, Utime now, Utime at,
                  const std::vector<TrajectorySegment>& segments);

/// `segment` from `begin_s` on, for `duration_s`.
TrajectorySegment Shifted(const TrajectorySegment& segment, double begin_s, double duration_s);

}  // namespace citrine::planner
