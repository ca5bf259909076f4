#pragma once

#include <string>

#include "modules/reflection/traffic.h"

namespace citrine {

/// One line a channel of a live bus: type, messages and kB a second, lost and undecodable ones, age.
/// @param columns, rows of the terminal; lines are cut to it; 0: not cut
std::string LiveTable(const Traffic& traffic, double now_s, std::size_t columns, std::size_t rows);

/// The same of a log: rates over the mission time that it covers, and each channel's first and last message.
std::string LogTable(const Traffic& traffic);

/// "01:23.450"
std::string MissionTimeText(Utime utime);

}  // namespace citrine
