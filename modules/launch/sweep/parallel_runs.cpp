#include "modules/launch/sweep/parallel_runs.h"

#include <signal.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/config/config.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/project.h"
#include "modules/launch/supervisor.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr const char* kParallel = "parallel";
constexpr const char* kJobShell = "PARALLEL_SHELL=/bin/sh";  // whatever the user's, and where there is none
constexpr std::chrono::milliseconds kPoll{200};
constexpr int kStartNoMore = SIGHUP;  // to GNU Parallel
constexpr std::size_t kJobLogFields =
    9;  // number, host, start, runtime, sent, received, exit code, signal, command

std::string ReadText(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A job a line: its folder, a tab, and the shell that flies it.
void WriteJobList(const std::vector<SweepJob>& jobs, const ParallelOptions& options, const fs::path& file) {
  std::ofstream out(file);
  for (const SweepJob& job : jobs)
    out << job.folder << "\t" << ShellLine(job, options.program, options.keep_logs) << "\n";
  out.close();
  if (!out) throw ConfigError(file.string() + ": cannot be written");
}

std::vector<std::string> ArgumentsOf(const ParallelOptions& options, const fs::path& list,
                                     const fs::path& log) {
  std::vector<std::string> arguments = {
      "env",           "-C",
      ProjectFolder(), kJobShell,
      kParallel,       "--will-cite",
      "--arg-file",    list,
      "--colsep",      "\t",
      "--joblog",      log,
      "--jobs",        options.jobs > 0 ? std::to_string(options.jobs) : "100%"};
  if (!options.hosts.empty())
    arguments.insert(arguments.end(),
                     {"--sshlogin", options.hosts, "--workdir", ProjectFolder(), "--return", "{1}"});
  arguments.emplace_back("sh -c {2}");
  return arguments;
}

}  // namespace

std::vector<EndedJob> ReadJobLog(const std::string& text) {
  std::vector<EndedJob> ended;
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream in(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
    if (fields.size() < kJobLogFields) continue;
    const std::size_t sequence = std::strtoul(fields[0].c_str(), nullptr, 10);
    const double start_s = std::strtod(fields[2].c_str(), nullptr);
    const double wall_s = std::strtod(fields[3].c_str(), nullptr);
    const int exit_code = std::atoi(fields[6].c_str()), signal = std::atoi(fields[7].c_str());
    if (sequence > 0) ended.push_back({sequence - 1, signal > 0 ? 128 + signal : exit_code, start_s, wall_s});
  }
  return ended;
}

bool RunInParallel(const std::vector<SweepJob>& jobs, const ParallelOptions& options,
                   const std::function<void(const EndedJob&)>& on_end) {
  const fs::path list = fs::path(options.folder) / "jobs.tsv", log = fs::path(options.folder) / kJobLog;
  WriteJobList(jobs, options, list);
  fs::remove(log);
  Supervisor supervisor(options.folder);
  supervisor.Start({kParallel, ArgumentsOf(options, list, log)});

  std::size_t heard = 0;
  int forwarded = 0;
  std::vector<Departure> departures;
  while (departures.empty()) {
    std::this_thread::sleep_for(kPoll);
    departures = supervisor.TakeDepartures();
    for (; forwarded < Interrupts(); ++forwarded) {
      if (forwarded == 0)
        std::fprintf(stderr, "citrine: waiting for the missions under way; once more to end them at once\n");
      supervisor.Signal(kParallel, forwarded == 0 ? kStartNoMore : SIGTERM);
    }
    const std::vector<EndedJob> ended = ReadJobLog(ReadText(log));
    for (; heard < ended.size(); ++heard)
      if (ended[heard].index < jobs.size()) on_end(ended[heard]);
  }
  if (heard == 0 && Interrupts() == 0)
    throw ConfigError("GNU Parallel has run nothing (" + departures.front().how() + "):\n" +
                      supervisor.LastWords(kParallel, 5));
  return heard == jobs.size();
}

}  // namespace citrine
