#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/pose.h"
#include "core/quality/quality_goal.h"
#include "core/sensor/lidar_model.h"
#include "sim/lidar/ray_scene.h"
#include "sim/lidar/reachability.h"
#include "sim/world/true_surface.h"

namespace citrine::sim {

/// What of the true surface can be seen at all; 0 or 1 for each of its samples.
struct Observability {
  std::vector<std::uint8_t>
      observable;  ///< unoccluded from a reachable pose, within [r_min, r_max] and the level field of view
  std::vector<std::uint8_t> within_goal;  ///< the same from within d*
};

/// Looks at every sample from the lattice, the nearest poses first.
Observability FindObservable(const std::vector<SurfaceSample>& samples, const ReachableLattice& lattice,
                             const RayScene& scene, const LidarModel& model, const QualityGoals& goals);

/// The same, kept in a file of `cache_folder` whose name holds the world's hash and a digest of everything
/// else that the answer depends on. A folder that cannot be written or a damaged file only costs the time.
Observability FindObservableCached(const std::string& cache_folder, const std::vector<SurfaceSample>& samples,
                                   const ReachableLattice& lattice, const RayScene& scene,
                                   const LidarModel& model, const QualityGoals& goals);

/// Which of the sensor poses at which scans were taken was the first to see each sample from within d*:
/// unoccluded, within range and within the field of view as the sensor was tilted then. Its index, or -1
/// where none did.
std::vector<int> FirstSeenBy(const std::vector<SurfaceSample>& samples, const std::vector<Pose>& X_WS,
                             const RayScene& scene, const LidarModel& model, const QualityGoals& goals);

}  // namespace citrine::sim
