#pragma once

#include <optional>
#include <string>

namespace citrine {

/// Finds a bus for the processes of a mission: the host's own, or, if asked or if the host has no multicast,
/// a private one. To be called before the first thread starts.
/// @return its LCM URL; nothing where a private one is refused: then the mission is flown in process
/// @throws std::runtime_error if another mission is on the bus or the bus is deaf, with what to do about it
std::optional<std::string> ChooseBus(bool isolate);

}  // namespace citrine
