#pragma once

#include <exception>
#include <string>

#include "modules/channels.h"
#include "modules/runtime/log_event.h"

namespace citrine {

/// Calls `visit` with every channel of the table.
template <class Visit>
void ForEveryChannel(Visit&& visit) {
  visit(channels::kClock);
  visit(channels::kStepDone);
  visit(channels::kUavState);
  visit(channels::kLidarScan);
  visit(channels::kPointCloud);
  visit(channels::kMapBlocks);
  visit(channels::kMapSummary);
  visit(channels::kMapOctree);
  visit(channels::kMissionProgress);
  visit(channels::kFleetStatus);
  visit(channels::kFleetAssignment);
  visit(channels::kStrategy);
  visit(channels::kPath);
  visit(channels::kTrajectory);
  visit(channels::kFlightStatus);
  visit(channels::kMissionConfig);
  visit(channels::kModuleHealth);
}

/// The 1..N of UAV<i>_<noun>; 0 for a channel that is not a UAV's.
int UavOfChannel(const std::string& channel);

template <class Message>
bool IsOn(const Channel<Message>& channel, const std::string& name) {
  return name == channel.name;
}
template <class Message>
bool IsOn(const UavChannel<Message>& channel, const std::string& name) {
  const int uav = UavOfChannel(name);
  return uav > 0 && name == channel.Of(uav);
}

/// Decodes one message of a log as what travels on its channel, and calls `hear(message)`.
/// @return false if the channel is not in the table, or the message is not of its type or cut short
template <class Hear>
bool WithMessage(const LogEvent& event, Hear&& hear) {
  bool decoded = false;
  const auto try_as = [&]<class Message>(Message message) {
    const int size = static_cast<int>(event.bytes.size());
    try {
      decoded = message.decode(event.bytes.data(), 0, size) == size;
    } catch (const std::exception&) {  // a count that cannot be
    }
    if (decoded) hear(message);
  };
  ForEveryChannel([&]<template <class> class On, class Message>(const On<Message>& channel) {
    if (IsOn(channel, event.channel)) try_as(Message{});
  });
  return decoded;
}

}  // namespace citrine
