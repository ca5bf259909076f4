#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "core/config/config.h"
#include "logs/number_text.h"
#include "logs/sweep_tables.h"
#include "modules/launch/commands.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/sweep/parallel_runs.h"
#include "modules/launch/sweep/sweep_folder.h"
#include "modules/launch/sweep/sweep_progress.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

/// Those that are to be flown. @throws ConfigError rather than to mix builds or to take away results unasked
std::vector<SweepJob> OpenJobs(const Sweep& sweep, const std::string& digest, bool again) {
  std::vector<SweepJob> open;
  std::size_t of_another_build = 0;
  for (const SweepJob& job : sweep.jobs) {
    const JobState state = StateOf(job, digest);
    of_another_build += state == JobState::kOfAnotherBuild;
    if (again || state == JobState::kOpen) open.push_back(job);
  }
  if (of_another_build > 0 && !again)
    throw ConfigError(
        sweep.folder + ": " + std::to_string(of_another_build) +
        " finished missions were flown by another build; --again flies all anew, --tables writes "
        "the tables of what is there, --out takes another folder");
  return open;
}

/// The program that flies: on other hosts what is built there, here a copy of this one, which no build under
/// way replaces; gone when the sweep is over.
class Program {
 public:
  Program(const Sweep& sweep, const SweepOptions& options) {
    if (!options.hosts.empty()) return;
    copy_ = fs::path(sweep.folder) / "launch";
    fs::copy_file("/proc/self/exe", copy_, fs::copy_options::overwrite_existing);
  }
  ~Program() {
    std::error_code ignored;
    if (!copy_.empty()) fs::remove(copy_, ignored);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  std::string path() const { return copy_.empty() ? "./citrine" : copy_.string(); }

 private:
  fs::path copy_;
};

int SlotsOf(const SweepOptions& options) {
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  const auto hosts = 1 + std::count(options.hosts.begin(), options.hosts.end(), ',');
  return static_cast<int>(hosts) * (options.jobs > 0 ? options.jobs : processors);
}

/// What one mission came to, in a line.
std::string Line(const SweepJob& job, const EndedJob& ended) {
  std::string text = job.world + " " + job.variant + " seed " + std::to_string(job.seed) + ": ";
  const auto metrics = MetricsOf(job);
  if (!metrics)
    return text + "no result (exit code " + std::to_string(ended.exit_code) + "), see " + job.folder +
           "/run.log";
  text += metrics->stop_reason + ", makespan " + logs::Fixed(metrics->makespan_m, 1) + " m, average path " +
          logs::Fixed(metrics->average_path_m, 1) + " m, coverage " + logs::Fixed(metrics->coverage_pct, 1) +
          " %, F " + logs::Fixed(metrics->f_score_pct, 1) + " %";
  if (metrics->collisions.value_or(0) > 0)
    text += ", " + std::to_string(*metrics->collisions) + " collisions";
  return text;
}

/// Flies what is open. @return how many ended without a result; nothing if it was interrupted
std::optional<std::size_t> Fly(const Sweep& sweep, const std::vector<SweepJob>& open,
                               const SweepOptions& options, const std::string& digest) {
  const Program program(sweep, options);
  for (const SweepJob& job : open) Begin(job, digest);
  SweepProgress progress(open, SlotsOf(options));
  std::size_t failed = 0;
  const auto on_end = [&](const EndedJob& ended) {
    progress.Ended(ended.index, ended.wall_s);
    const SweepJob& job = open[ended.index];
    failed += !MetricsOf(job);
    const std::size_t before = sweep.jobs.size() - open.size();
    std::fprintf(stderr, "citrine: %zu/%zu %s; %s left\n", before + progress.ended(), sweep.jobs.size(),
                 Line(job, ended).c_str(), logs::MinutesSeconds(progress.TimeLeft_s().value_or(0)).c_str());
  };
  const bool all = RunInParallel(
      open, {sweep.folder, program.path(), options.jobs, options.hosts, sweep.plan.sweep.keep_logs}, on_end);
  if (!all) return std::nullopt;
  return failed;
}

}  // namespace

int RunSweep(const SweepOptions& options) {
  const Sweep sweep = PlanSweep(options);
  for (const std::string& sentence : sweep.left_out) std::fprintf(stderr, "citrine: %s\n", sentence.c_str());
  if (options.list) {
    for (const SweepJob& job : sweep.jobs)
      std::printf("./citrine %s --out %s\n", job.command.c_str(), ShellWord(job.folder).c_str());
    return kCompleted;
  }
  CountInterrupts();
  fs::create_directories(sweep.folder);
  std::optional<std::size_t> failed = 0;
  if (!options.tables) {
    const std::string digest = ProgramDigest();
    const std::vector<SweepJob> open = OpenJobs(sweep, digest, options.again);
    std::fprintf(stderr, "citrine: %s, %zu missions, %zu of them finished; results in %s\n",
                 sweep.plan.sweep.name.c_str(), sweep.jobs.size(), sweep.jobs.size() - open.size(),
                 sweep.folder.c_str());
    if (!open.empty()) failed = Fly(sweep, open, options, digest);
  }
  const logs::SweepResults results = ReadResults(sweep);
  WriteTables(sweep, results);
  std::fputs(logs::SweepMarkdown(results).c_str(), stdout);
  std::printf("\n%s\n", (fs::path(sweep.folder) / "report.html").c_str());
  if (!failed) return kInterrupted;
  return *failed == 0 ? kCompleted : kNotCompleted;
}

}  // namespace citrine
