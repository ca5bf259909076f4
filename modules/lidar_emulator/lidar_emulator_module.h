#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <citrine_lcm/uav_state_t.hpp>

#include "core/random.h"
#include "core/vehicle/uav_state.h"
#include "modules/runtime/module.h"
#include "sim/lidar/lidar_emulator.h"

namespace citrine {

/// The fleet's LiDARs: hears UAV<i>_STATE, says UAV<i>_LIDAR_SCAN at lidar.rate_hz, the UAVs staggered over
/// the period. A scan is taken at the newest pose heard, which is also the pose that it says; the sensor sits
/// in the body's origin.
class LidarEmulatorModule : public Module {
 public:
  static constexpr const char* kName = "lidar_emulator";
  static constexpr const char* kSummary = "fires the LiDARs' beams into the world with Embree";
  static constexpr bool kHearsMap = false;
  static constexpr bool kPerUav = false;

  /// @throws sim::WorldError for a world that cannot be used
  explicit LidarEmulatorModule(const ModuleContext& context);

  void Tick(const Step& step) override;

 private:
  struct Sensor {
    Every every;
    Random noise;
    std::optional<UavState> newest;
    std::optional<Utime> scanned;  ///< utime of the state that was scanned last
  };

  void HearStates();
  std::vector<Eigen::Vector3d> TeammatesOf(std::size_t self) const;

  Bus& bus_;
  Health& health_;
  sim::LidarEmulator emulator_;
  std::vector<Sensor> sensors_;  ///< by UAV id - 1
  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states_;
};

}  // namespace citrine
