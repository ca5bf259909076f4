#include "modules/replay/said_by.h"

#include "modules/every_channel.h"

namespace citrine {
namespace {

template <class... Channels>
bool IsOnOneOf(const std::string& name, const Channels&... channels) {
  return (IsOn(channels, name) || ...);
}

bool IsFusions(const std::string& channel) {
  return IsOnOneOf(channel, channels::kMapBlocks, channels::kMapSummary, channels::kMapOctree,
                   channels::kMissionProgress);
}
bool IsAPlanners(const std::string& channel) {
  return IsOnOneOf(channel, channels::kFleetStatus, channels::kPath, channels::kStrategy);
}
bool IsASmoothers(const std::string& channel) {
  return IsOnOneOf(channel, channels::kTrajectory, channels::kFlightStatus);
}

bool IsCorrectionOf(int uav, const LogEvent& event) {
  bool is_own = false;
  if (IsOn(channels::kFleetAssignment, event.channel))
    WithMessage(event, [&](const auto& message) {
      if constexpr (requires { message.sender; }) is_own = message.sender == uav;
    });
  return is_own;
}

}  // namespace

bool SaidBy(const ModuleId& module, const LogEvent& event) {
  const bool own_channel = module.uav == UavOfChannel(event.channel);
  if (module.name == "map_fusion") return own_channel && IsFusions(event.channel);
  if (module.name == "view_planner")
    return (own_channel && IsAPlanners(event.channel)) || IsCorrectionOf(module.uav, event);
  return module.name == "trajectory_smoother" && own_channel && IsASmoothers(event.channel);
}

bool IsDecision(const LogEvent& event) {
  return IsAPlanners(event.channel) || IsASmoothers(event.channel) ||
         IsOn(channels::kFleetAssignment, event.channel);
}

}  // namespace citrine
