#pragma once

#include <string>
#include <vector>

namespace citrine {

/// What the user of `sweep` asks for.
struct SweepOptions {
  std::string sweep;             ///< a name in missions/sweeps/ or a file
  int jobs = 0;                  ///< missions at once on a host; 0: one a processor
  std::string hosts;             ///< of SSH, separated by commas, ":" for this machine; empty: this machine
  std::string seeds;             ///< "1-10"; empty: the sweep's own
  std::vector<std::string> set;  ///< section.key=value for all missions, after the sweep's own
  std::string only;              ///< part of <world>/<variant>; empty: all
  std::string out;               ///< empty: results/sweeps/<name>
  bool again = false;            ///< fly what is finished anew
  bool tables = false;           ///< fly nothing; write the tables of what is there
  bool list = false;             ///< only show the commands
};

}  // namespace citrine
