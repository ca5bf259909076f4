#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace citrine {

/// How a log of a long mission is kept: in parts NAME.000, NAME.001, ... instead of one file NAME.
struct LogSplit {
  std::int64_t part_bytes = 0;  ///< a part that has reached this is the last but one; 0: one file
  int keep = 0;                 ///< parts, the newest; 0: all
};

/// "NAME.007"
std::string LogPart(const std::string& name, int part);

/// The files of a log in order: itself, or its parts. Empty if there is neither.
std::vector<std::string> LogFiles(const std::string& name);

}  // namespace citrine
