#pragma once

#include <map>
#include <optional>

#include <citrine_lcm/point_cloud_t.hpp>

#include "core/sensor/point_cloud.h"

namespace citrine {

/// Puts the chunks of sweeps together again, one sweep a UAV at a time. A sweep that lost chunks is taken as
/// it is once the next one of that UAV begins.
class CloudChunks {
 public:
  /// @return a sweep that is as whole as it will ever be. @throws BadMessage for a chunk that is none, or
  /// does not belong to the sweep that it says
  std::optional<PointCloud> Hear(int uav, const citrine_lcm::point_cloud_t& message);

 private:
  struct Sweep {
    PointCloud cloud;
    int num_chunks = 0;
    std::vector<bool> heard;
  };
  std::map<int, Sweep> sweeps_;
};

}  // namespace citrine
