#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose.h"
#include "core/map/tsdf_map.h"
#include "fusion/tsdf_integrator.h"

namespace citrine::fusion {

/// Fuses clouds that were recorded somewhere, into a map that grows with them. The pattern of beams is
/// guessed from the first cloud with points; beams that are missing carve nothing.
class CloudFuser {
 public:
  struct Options {
    double voxel_m = 0.25, truncation_m = 0.5;
    double range_min_m = 0.5, range_max_m = 30;
    int threads = 1;
  };
  explicit CloudFuser(const Options& options);

  /// @return how many points lie within range
  std::size_t Integrate(const std::vector<Eigen::Vector3f>& points_S, const Pose& X_WS);

  const TsdfMap& map() const { return map_; }

 private:
  Options options_;
  TsdfMap map_;
  TsdfIntegrator integrator_;
  std::optional<LidarModel> model_;
};

}  // namespace citrine::fusion
