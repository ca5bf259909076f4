#pragma once

#include <cstdint>
#include <string>

namespace citrine {

/// What the user of `explain` asks for.
struct ExplainOptions {
  std::string run;  ///< result folder or log
  int uav = 1;
  std::int64_t decision = 1;
  int rows = 10;
  std::string out;  ///< picture; empty: explain-uav<i>-<n>.png beside the log
};

}  // namespace citrine
