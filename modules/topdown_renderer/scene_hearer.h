#pragma once

#include <memory>
#include <vector>

#include "modules/fleet_inboxes.h"
#include "modules/runtime/module.h"
#include "viz/scene.h"

namespace citrine {

/// Hears all that a picture shows and keeps the scene of it.
class SceneHearer {
 public:
  explicit SceneHearer(const ModuleContext& context);

  /// Takes over what was said before this step.
  void Update(const Step& step);

  /// The scene now, with the active elements of the map as it is.
  const viz::Scene& Finish();

 private:
  viz::SceneUav& UavOf(int id) { return scene_.uavs[static_cast<std::size_t>(id - 1)]; }
  void HearStates();
  void HearPlans();
  void HearAssignments();
  void ForgetWhatIsOver(bool mission_is_over);
  void HearProgress();

  Bus& bus_;
  int uavs_;
  std::shared_ptr<MapHearer> map_hearer_;
  viz::Scene scene_;
  Utime assignment_expiry_ = 0;
  std::int64_t newest_plan_ = 0;
  FleetInboxes inboxes_;
};

}  // namespace citrine
