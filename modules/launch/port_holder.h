#pragma once

#include <string>

namespace citrine {

/// Who holds the UDP port of an LCM URL without sharing it, as far as this user may see: "\"python3\" (pid
/// 812)". Empty if nobody that can be seen.
std::string HolderOfPort(const std::string& lcm_url);

/// The UDP port of an LCM URL, such as 7667; 7667 for one that names none.
int PortOf(const std::string& lcm_url);

}  // namespace citrine
