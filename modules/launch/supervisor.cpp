#include "modules/launch/supervisor.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <fstream>
#include <system_error>

namespace citrine {
namespace {

/// The child's half of Start(): only calls that are safe between fork and exec.
[[noreturn]] void Become(char* const* arguments, int log, int failure, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execvp(arguments[0], arguments);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(failure, &error, sizeof error);
  _exit(127);
}

}  // namespace

std::string Departure::how() const {
  if (signal == 0) return "exited with " + std::to_string(exit_code);
  const char* abbreviation = sigabbrev_np(signal);
  return "died (" + (abbreviation ? std::string("SIG") + abbreviation : "signal " + std::to_string(signal)) +
         ")";
}

Supervisor::Supervisor(std::string logs_folder) : logs_folder_(std::move(logs_folder)) {}

Supervisor::~Supervisor() {
  SignalAllBut("", SIGKILL);
  for (const auto& [name, pid] : running_) waitpid(pid, nullptr, 0);
}

std::string Supervisor::LogFile(const std::string& name) const { return logs_folder_ + "/" + name + ".log"; }

void Supervisor::Start(const ProcessSpec& process) {
  std::vector<char*> arguments;
  for (const std::string& argument : process.arguments)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const auto fail = [&](int error, const std::string& what) {
    throw std::system_error(error, std::generic_category(), what);
  };

  const int log = open(LogFile(process.name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0) fail(errno, LogFile(process.name));
  int failure[2];  // closed by a successful exec, else carries errno
  if (pipe2(failure, O_CLOEXEC) != 0) fail(errno, "pipe");
  const pid_t parent = getpid(), pid = fork();
  if (pid == 0) Become(arguments.data(), log, failure[1], parent);
  close(log);
  close(failure[1]);
  int error = errno;
  const bool failed = pid < 0 || read(failure[0], &error, sizeof error) > 0;
  close(failure[0]);
  if (failed && pid > 0) waitpid(pid, nullptr, 0);
  if (failed) fail(error, process.arguments[0]);
  running_[process.name] = pid;
}

std::vector<Departure> Supervisor::TakeDepartures() {
  std::vector<Departure> departures;
  for (const auto& [name, pid] : running_) {
    int status = 0;
    if (waitpid(pid, &status, WNOHANG) != pid) continue;
    departures.push_back(
        {name, WIFEXITED(status) ? WEXITSTATUS(status) : 0, WIFSIGNALED(status) ? WTERMSIG(status) : 0});
  }
  for (const Departure& departure : departures) running_.erase(departure.name);
  return departures;
}

std::vector<std::string> Supervisor::running() const {
  std::vector<std::string> names;
  for (const auto& [name, pid] : running_) names.push_back(name);
  return names;
}

void Supervisor::Signal(const std::string& name, int signal) const {
  if (const auto it = running_.find(name); it != running_.end()) kill(it->second, signal);
}

void Supervisor::SignalAllBut(const std::string& name, int signal) const {
  for (const auto& [other, pid] : running_)
    if (other != name) kill(pid, signal);
}

std::string Supervisor::LastWords(const std::string& name, int num_lines) const {
  std::ifstream in(LogFile(name));
  std::deque<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
    if (static_cast<int>(lines.size()) > num_lines) lines.pop_front();
  }
  std::string words;
  for (const std::string& line : lines) words += "    " + line + "\n";
  return words;
}

}  // namespace citrine
