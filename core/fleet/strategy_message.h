#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace citrine {

/// What a strategy says to its peers beyond the common messages; only the strategy knows what the bytes mean.
struct StrategyMessage {
  int from_uav = 0;  ///< 1..N
  int to_uav = 0;    ///< 1..N; 0: all
  std::string kind;
  std::vector<std::uint8_t> bytes;
};

}  // namespace citrine
