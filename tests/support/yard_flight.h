#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "modules/codec/uav_state.h"
#include "modules/map_hearer.h"
#include "modules/runtime/module.h"
#include "tests/support/analytic_scene.h"
#include "tests/support/said_map.h"

namespace citrine::test {

/// A small yard with a box in it, for modules that hear the map: one module under test and its peers, on one
/// bus in this process, stepped by 20 ms.
template <class M>
class YardFlight {
 public:
  YardFlight() {
    config.mission.volume_min_m = Eigen::Vector3d(-8, -8, 0);
    config.mission.volume_max_m = Eigen::Vector3d(8, 8, 6);
    config.mission.spawns_m = {{-3, -5, 2.5}, {3, -5, 2.5}};
    config.mission.uavs = 2;
    scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0);
    scene.AddBox({-1, 2, 0}, {1, 4, 3});
  }

  void Begin(int uav) {
    map_hearer = std::make_shared<MapHearer>(config, bus);
    module.emplace(ModuleContext{config, bus, health, uav, map_hearer});
  }
  void SayMap() {
    test::SayMap(config, peers, [this](const Eigen::Vector3d& p_W) { return scene.Distance(p_W); });
  }
  void SayState(int uav) {
    UavState state;
    state.utime = now();
    state.X_WB.p = config.mission.spawns_m[static_cast<std::size_t>(uav - 1)];
    peers.Publish(channels::kUavState, uav, Encode(state));
  }
  void Tick(bool last = false) {
    const citrine::Step step{++index_, now(), last};
    for (Bus* each : {&bus, &peers}) each->BeginStep(step, true);
    module->Tick(step);
    while (bus.Handle(0) > 0) {
    }
  }
  void Fly(double seconds) {
    for (const Utime end = now() + FromSeconds(seconds); now() < end;) Tick();
  }
  Utime now() const { return index_ * 20'000; }

  MissionConfig config;
  AnalyticScene scene;
  std::shared_ptr<Transport> transport = std::make_shared<Transport>("memq://");
  Bus bus{transport};    ///< the module's
  Bus peers{transport};  ///< of all others
  Health health;
  std::shared_ptr<MapHearer> map_hearer;
  std::optional<M> module;

 private:
  std::int64_t index_ = 0;
};

}  // namespace citrine::test
