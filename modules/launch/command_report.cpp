#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "modules/launch/commands.h"
#include "modules/launch/results_table.h"
#include "modules/mission_report/mission_report.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

/// What the mission's own report knew and its log does not.
void TakeOver(const fs::path& metrics_file, ReportInputs& inputs) {
  std::ifstream in(metrics_file);
  if (!in) return;
  std::ostringstream text;
  text << in.rdbuf();
  const logs::Metrics before = logs::MetricsFromJson(text.str());
  inputs.stop_reason = before.stop_reason;
  inputs.wall_time_s = before.wall_time_s;
}

}  // namespace

int Report(const std::string& folder_or_log) {
  const fs::path log = FindLog(folder_or_log);
  const fs::path folder = fs::absolute(log).parent_path();
  ReportInputs inputs = InputsFromLog(log);
  TakeOver(folder / "metrics.json", inputs);
  std::fputs(ResultsTable(WriteReport(folder, inputs), folder).c_str(), stdout);
  return kCompleted;
}

}  // namespace citrine
