#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>

#include "core/config/config_file.h"
#include "logs/number_text.h"
#include "modules/mission_report/mission_report.h"

namespace {

namespace fs = std::filesystem;

std::string ReadText(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// What a former report of the folder knows and the log does not.
void TakeOver(const fs::path& metrics_path, citrine::ReportInputs& inputs) {
  if (!fs::exists(metrics_path)) return;
  const citrine::logs::Metrics before = citrine::logs::MetricsFromJson(ReadText(metrics_path));
  inputs.wall_time_s = before.wall_time_s;
  inputs.stop_reason = before.stop_reason;
  inputs.in_process = before.in_process;
  inputs.pace = before.pace;
  if (before.commit) inputs.commit = *before.commit;
}

void Print(const citrine::logs::Metrics& m, const fs::path& folder) {
  using citrine::logs::Fixed;
  std::cout << (m.completed ? "surface complete" : "not completed: " + m.stop_reason) << " after "
            << citrine::logs::MinutesSeconds(m.mission_time_s) << "; makespan " << Fixed(m.makespan_m, 1)
            << " m, coverage " << Fixed(m.coverage_pct, 1) << " %, precision " << Fixed(m.precision_pct, 1)
            << " %, F-score " << Fixed(m.f_score_pct, 1) << " %, collisions " << m.collisions.value_or(0)
            << "\n"
            << (folder / "report.html").string() << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes metrics.json, report.html, progress.csv and uav<i>.tum from a log or a result folder");
  std::string source, mission, out;
  std::vector<std::string> overrides;
  app.add_option("source", source, "a log, or a folder that holds mission.lcmlog")->required();
  app.add_option("-P,--mission", mission, "mission file; default: the MISSION_CONFIG of the log");
  app.add_option("-O,--set", overrides, "section.key=value; with --mission");
  app.add_option("--out", out, "folder to write to; default: that of the log");
  CLI11_PARSE(app, argc, argv);
  try {
    const fs::path log = fs::is_directory(source) ? fs::path(source) / "mission.lcmlog" : fs::path(source);
    const fs::path folder = out.empty() ? fs::absolute(log).parent_path() : fs::path(out);
    citrine::ReportInputs inputs;
    if (mission.empty())
      inputs = citrine::InputsFromLog(log);
    else
      inputs.config = citrine::ParseMission(ReadText(mission), overrides);
    inputs.log_path = log;
    TakeOver(log.parent_path() / "metrics.json", inputs);
    Print(citrine::WriteReport(folder, inputs), folder);
  } catch (const std::exception& error) {
    std::cerr << "mission_report: " << error.what() << "\n";
    return 2;
  }
  return 0;
}
