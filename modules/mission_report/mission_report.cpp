#include "modules/mission_report/mission_report.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/config/config_file.h"
#include "core/digest.h"
#include "core/map/ply.h"
#include "logs/flight_measures.h"
#include "logs/number_text.h"
#include "logs/progress_csv.h"
#include "logs/report_html.h"
#include "logs/tum.h"
#include "modules/mission_report/flight_record_reader.h"
#include "modules/mission_report/ground_truth.h"
#include "modules/mission_report/mission_metrics.h"
#include "modules/mission_report/reconstruction.h"
#include "modules/runtime/log_digest.h"
#include "modules/runtime/log_reader.h"
#include "viz/frame_writer.h"
#include "viz/mesh_picture.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

void WriteFile(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
}

std::vector<std::uint8_t> ReadBytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TriMesh MeshOf(const fs::path& folder, const std::vector<LogEvent>& events, const MissionConfig& config) {
  if (fs::exists(folder / "mesh.ply")) return ReadPly(folder / "mesh.ply");
  return RebuildMesh(events, config);
}

std::string DigestOf(const std::vector<LogEvent>& events) {
  LogDigest digest;
  for (const LogEvent& event : events) digest.Add(event);
  return Hex(digest.value());
}

/// Where the UAVs were first; what the mission asks for is moved by the seed.
std::vector<Eigen::Vector3d> StartsOf(const logs::FlightRecord& flight) {
  std::vector<Eigen::Vector3d> starts_W;
  for (const logs::UavFlight& uav : flight.uavs)
    if (!uav.states.empty()) starts_W.push_back(uav.states.front().X_WB.p);
  return starts_W;
}

std::vector<logs::Timed<Pose>> ScanPosesOf(const logs::FlightRecord& flight) {
  std::vector<logs::Timed<Pose>> X_WS;
  for (const logs::UavFlight& uav : flight.uavs) X_WS.insert(X_WS.end(), uav.scans.begin(), uav.scans.end());
  return X_WS;
}

/// The metrics that need the true world.
void HoldAgainstTruth(const GroundTruth& truth, const TriMesh& mesh, logs::ReportPage& page) {
  logs::Metrics& m = page.metrics;
  m.world_hash = Hex(truth.world().hash);
  page.score = truth.Score(mesh);
  if (page.score) {
    m.coverage_pct = page.score->coverage_pct;
    m.precision_pct = page.score->precision_pct;
    m.f_score_pct = page.score->f_score_pct;
    m.observable_coverage_pct = page.score->observable_coverage_pct;
    m.surface_error_mean_m = page.score->surface_error_mean_m;
    m.surface_error_p95_m = page.score->surface_error_p95_m;
  }
  GroundTruth::GoalCoverage goal = truth.SeenFrom(ScanPosesOf(page.record));
  if (!goal.all_pct.empty()) m.goal_coverage_pct = goal.all_pct.back().second;
  if (!goal.objects_pct.empty()) m.object_goal_coverage_pct = goal.objects_pct.back().second;
  page.goal_coverage_pct = std::move(goal.all_pct);
  page.object_goal_coverage_pct = std::move(goal.objects_pct);
  for (const logs::UavFlight& uav : page.record.uavs)
    page.clearance_by_uav.push_back(logs::ClearanceOverTime(
        uav.states, [&](const Eigen::Vector3d& p_W) { return truth.Clearance(p_W); }));
  m.min_obstacle_clearance_m = logs::MinOf(page.clearance_by_uav);
  page.notes.push_back(
      logs::Fixed(100 * truth.dropped_share(), 2) +
      " % of the world's surface in the mission volume has solid on both sides and is left out.");
  if (truth.observable_share())
    page.notes.push_back(logs::Fixed(100 * *truth.observable_share(), 2) +
                         " % of the true surface can be observed from a pose that a UAV can reach.");
}

/// The command that flies the mission of a log again.
std::string CommandOf(const Recording& recording, const MissionConfig& config) {
  std::string command = "./citrine run " + config.mission.name + " --strategy " + config.planner.strategy +
                        " --uavs " + std::to_string(config.mission.uavs) + " --seed " +
                        std::to_string(config.mission.seed);
  if (recording.config)
    for (const std::string& override_text : recording.config->overrides)
      command += " --set '" + override_text + "'";
  return command;
}

void DrawMeshPicture(const TriMesh& mesh, const MissionConfig& config, const fs::path& path) {
  viz::MeshView view;
  view.weight_goal = static_cast<float>(config.quality_goals().w_star_max());
  viz::WritePng(path.string(), viz::DrawMesh(mesh, view));
}

void WriteAll(const fs::path& folder, const logs::ReportPage& page) {
  for (std::size_t i = 0; i < page.record.uavs.size(); ++i)
    WriteFile(folder / ("uav" + std::to_string(i + 1) + ".tum"), logs::ToTum(page.record.uavs[i].states));
  WriteFile(folder / "progress.csv", logs::ProgressCsv(page.record));
  WriteFile(folder / "report.html", logs::ReportHtml(page));
  WriteFile(folder / "metrics.json", logs::ToJson(page.metrics));
}

}  // namespace

logs::Metrics WriteReport(const std::string& out_dir, const ReportInputs& inputs) {
  const fs::path folder(out_dir);
  fs::create_directories(folder);
  const std::vector<LogEvent> events = ReadInOrder(inputs.log_path);
  Recording recording = ReadRecording(events);

  logs::ReportPage page;
  page.metrics = MetricsOf(recording, inputs);
  page.metrics.log_digest = DigestOf(events);
  page.command = inputs.command.empty() ? CommandOf(recording, inputs.config) : inputs.command;
  page.record = std::move(recording.flight);
  page.balance = inputs.config.planner.balance;
  page.d_star_m = inputs.config.quality.d_star_m;
  page.limits = inputs.config.uav.limits;
  page.volume_W = inputs.config.volume_W();
  page.config_toml = ToToml(inputs.config);
  page.topdown_png = ReadBytes(folder / "topdown.png");
  if (recording.messages_bad > 0)
    page.notes.push_back(std::to_string(recording.messages_bad) +
                         " messages of the log do not decode and are left out.");
  const TriMesh mesh = MeshOf(folder, events, inputs.config);
  DrawMeshPicture(mesh, inputs.config, folder / "mesh.png");
  page.mesh_png = ReadBytes(folder / "mesh.png");
  try {
    const GroundTruth truth(inputs.config, StartsOf(page.record), inputs.cache_folder);
    HoldAgainstTruth(truth, mesh, page);
  } catch (const sim::WorldError& error) {
    page.notes.push_back(std::string("Nothing is held against the true world: ") + error.what());
  }
  WriteAll(folder, page);
  return page.metrics;
}

ReportInputs InputsFromLog(const std::string& log_path) {
  const Recording recording = ReadRecording(ReadInOrder(log_path));
  if (!recording.config)
    throw std::runtime_error(log_path + ": holds no MISSION_CONFIG, so nobody knows what was flown");
  ReportInputs inputs;
  inputs.log_path = log_path;
  inputs.config = ParseMission(recording.config->toml, recording.config->overrides);
  inputs.in_process = inputs.config.launch.in_process;
  inputs.pace = inputs.config.launch.pace;
  return inputs;
}

}  // namespace citrine
