#include <cstdio>

#include "modules/launch/commands.h"
#include "sim/world/world_report.h"

namespace citrine {

int ShowWorld(const std::string& file) {
  const sim::WorldReport report = sim::ReportWorld(file);
  std::fputs(report.text.c_str(), stdout);
  return report.ok ? kCompleted : kSetUpProblem;
}

}  // namespace citrine
