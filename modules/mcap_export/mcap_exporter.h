#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/fleet/fleet_status.h"
#include "core/quality/active_surface.h"
#include "core/trajectory/path.h"
#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"
#include "logs/mcap/mcap_writer.h"
#include "modules/fleet_inboxes.h"
#include "modules/map_hearer.h"
#include "modules/runtime/module.h"

namespace citrine {

/// Hears a mission and writes it down for viewers: poses, clouds, the surface as it grows, paths and goals,
/// progress. Says nothing.
class McapExporter : public Module {
 public:
  static constexpr const char* kName = "mcap_exporter";
  static constexpr const char* kSummary = "writes a mission down as an MCAP file";
  static constexpr bool kHearsMap = true;
  static constexpr bool kPerUav = false;

  /// @param writer outlives this; not finished here
  McapExporter(const ModuleContext& context, logs::McapWriter& writer);

  void Tick(const Step& step) override;

 private:
  /// What is known of one UAV, and the topics that are its own.
  struct Uav {
    std::uint16_t pose, cloud, plan, flight;
    std::optional<UavState> state;
    std::optional<FleetStatus> status;
    std::optional<Path> path;
    std::optional<Trajectory> trajectory;
    double flown_m = 0;
    bool plan_changed = false;
  };

  Uav& UavOf(int id) { return uavs_[static_cast<std::size_t>(id - 1)]; }
  int num_uavs() const { return config_.mission.uavs; }
  void HearStates();
  void HearScans();
  void HearPlans();
  void HearFleet();
  void WriteFlights(Utime now);
  void WritePlans(Utime now);
  void WriteSurface(Utime now);

  const MissionConfig config_;
  Bus& bus_;
  logs::McapWriter& writer_;
  std::shared_ptr<MapHearer> map_hearer_;
  ActiveSurface surface_;
  std::vector<Uav> uavs_;  ///< index: id - 1
  std::uint16_t transforms_, surface_topic_, fleet_, progress_topic_;
  Every flight_due_, surface_due_;
  std::int64_t written_revision_ = -1;

  FleetInboxes inboxes_;
  std::shared_ptr<Inbox<citrine_lcm::lidar_scan_t>> scans_;
};

}  // namespace citrine
