#pragma once

#include <optional>
#include <string>

namespace citrine {

/// Moves this process, and the children it starts from now on, into a network namespace of its own in which
/// multicast travels over the loopback interface alone. To be called before the first thread starts.
/// @return why it was refused; nothing on success
std::optional<std::string> IsolateNetwork();

}  // namespace citrine
