#include "modules/launch/sweep/sweep_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "core/digest.h"
#include "logs/number_text.h"
#include "logs/progress_csv.h"
#include "logs/sweep_html.h"
#include "logs/sweep_plots.h"
#include "logs/sweep_tables.h"
#include "modules/launch/project.h"
#include "modules/launch/sweep/parallel_runs.h"
#include "modules/mission_report/ground_truth.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

/// Where a job's folder is, whatever the present folder.
fs::path Place(const SweepJob& job) { return ProjectFolder() / job.folder; }

std::string ReadText(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in ? text.str() : "";
}

void WriteText(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
}

/// First line: the command; second: the build.
std::string JobText(const SweepJob& job, const std::string& program_digest) {
  return "./citrine " + job.command + "\nbuild " + program_digest + "\n";
}

std::map<std::string, logs::Series> SeriesOf(const SweepJob& job, const std::vector<std::string>& columns) {
  std::map<std::string, logs::Series> series;
  if (columns.empty()) return series;
  const std::string text = ReadText(Place(job) / "progress.csv");
  for (const std::string& column : columns) series[column] = logs::ColumnOverTime(text, column);
  return series;
}

std::string Joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// How the scores were taken (Knapitsch et al. 2017), for the foot of the tables.
std::string ScoringNote(const logs::SweepResults& results) {
  const logs::ScoreOptions score;
  std::set<std::string> thresholds;
  for (const logs::SweepRun& run : results.runs)
    thresholds.insert(logs::Fixed(run.metrics.threshold_m, 4) + " m");
  return "Coverage, precision and F-score at the threshold sqrt(3/2) d_s = " + Joined(thresholds) +
         "; true surface clipped to the mission volume, " + logs::Fixed(GroundTruth::kSamplesPerM2, 0) +
         " samples/m²; reconstruction not cropped, " + logs::Fixed(score.neighbours_per_m2, 0) +
         " points/m² for coverage, " + logs::Fixed(score.samples_per_m2, 0) +
         " points/m² against the exact true surface for precision; sampling seed " +
         std::to_string(GroundTruth::kSeed) + ".";
}

/// How long the last call of the sweep took to fly; empty if it flew nothing.
std::string DurationNote(const std::string& sweep_folder) {
  const std::vector<EndedJob> ended = ReadJobLog(ReadText(fs::path(sweep_folder) / kJobLog));
  if (ended.empty()) return "";
  double begin_s = ended[0].start_s, end_s = 0, work_s = 0;
  for (const EndedJob& job : ended) {
    begin_s = std::min(begin_s, job.start_s);
    end_s = std::max(end_s, job.start_s + job.wall_s);
    work_s += job.wall_s;
  }
  return "The last call flew and scored " + std::to_string(ended.size()) + " missions in " +
         logs::Fixed((end_s - begin_s) / 60, 1) + " minutes, " + logs::Fixed(work_s / (end_s - begin_s), 1) +
         " at a time on average, on a machine of " + std::to_string(std::thread::hardware_concurrency()) +
         " cores.";
}

void AddNotes(const Sweep& sweep, logs::SweepResults& results) {
  std::map<std::string, std::set<std::string>> hashes_by_world;
  std::set<std::string> commits, builds;
  for (const logs::SweepRun& run : results.runs) {
    hashes_by_world[run.world].insert(run.metrics.world_hash.value_or("unknown"));
    commits.insert(run.metrics.commit.value_or("unknown"));
  }
  for (const SweepJob& job : sweep.jobs)
    if (const std::string text = ReadText(Place(job) / "job.txt"); !text.empty())
      builds.insert(text.substr(text.find('\n') + 1, std::string::npos));
  results.notes.push_back(std::to_string(results.runs.size()) + " of " + std::to_string(sweep.jobs.size()) +
                          " missions are finished; commit " + Joined(commits) + ".");
  if (const std::string note = DurationNote(sweep.folder); !note.empty()) results.notes.push_back(note);
  if (builds.size() > 1)
    results.notes.push_back("The missions were flown by " + std::to_string(builds.size()) +
                            " different builds.");
  for (const SweepWorld& world : sweep.plan.worlds)
    if (hashes_by_world.contains(world.name))
      results.notes.push_back(world.title + ": world hash " + Joined(hashes_by_world[world.name]) + ".");
  for (const std::string& sentence : sweep.left_out) results.notes.push_back(sentence);
  if (!results.runs.empty()) results.notes.push_back(ScoringNote(results));
  results.notes.push_back(
      "Differences are paired by seed, with 95 % confidence intervals of Student's t; * p < 0.05, not "
      "corrected "
      "for the number of comparisons.");
}

}  // namespace

std::string ProgramDigest() {
  const std::string program = ReadText("/proc/self/exe");
  Digest digest;
  digest.Add(program.data(), program.size());
  return Hex(digest.value());
}

std::optional<logs::Metrics> MetricsOf(const SweepJob& job) {
  const std::string said = ReadText(Place(job) / "job.txt"), text = ReadText(Place(job) / "metrics.json");
  if (text.empty() || said.substr(0, said.find('\n')) != "./citrine " + job.command) return std::nullopt;
  try {
    const logs::Metrics metrics = logs::MetricsFromJson(text);
    if (metrics.stop_reason == "surface_complete" || metrics.stop_reason == "time_limit") return metrics;
  } catch (const std::runtime_error&) {
    return std::nullopt;  // the machine stopped while it was written
  }
  return std::nullopt;
}

JobState StateOf(const SweepJob& job, const std::string& program_digest) {
  if (!MetricsOf(job)) return JobState::kOpen;
  return ReadText(Place(job) / "job.txt") == JobText(job, program_digest) ? JobState::kFinished
                                                                          : JobState::kOfAnotherBuild;
}

void Begin(const SweepJob& job, const std::string& program_digest) {
  fs::create_directories(Place(job));
  fs::remove(Place(job) / "metrics.json");
  WriteText(Place(job) / "job.txt", JobText(job, program_digest));
}

logs::SweepResults ReadResults(const Sweep& sweep) {
  logs::SweepResults results;
  results.plan = sweep.plan;
  results.command = sweep.command;
  for (const SweepJob& job : sweep.jobs)
    if (const auto metrics = MetricsOf(job))
      results.runs.push_back(
          {job.world, job.variant, job.seed, *metrics, SeriesOf(job, sweep.plan.sweep.over_time)});
  AddNotes(sweep, results);
  return results;
}

void WriteTables(const Sweep& sweep, const logs::SweepResults& results) {
  const fs::path folder = sweep.folder;
  fs::create_directories(folder / "figures");
  WriteText(folder / "tables.md", logs::SweepMarkdown(results));
  WriteText(folder / "tables.tex", logs::SweepLatex(results));
  WriteText(folder / "runs.csv", logs::RunsCsv(results));
  WriteText(folder / "summary.csv", logs::SummaryCsv(results));
  const std::vector<logs::NamedFigure> figures = logs::SweepFigures(results);
  for (const logs::NamedFigure& figure : figures)
    WriteText(folder / "figures" / (figure.name + ".svg"), logs::ToSvgFile(figure.figure));
  WriteText(folder / "report.html", logs::SweepHtml(results, figures));
}

}  // namespace citrine
