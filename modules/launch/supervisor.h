#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace citrine {

/// A process to be started.
struct ProcessSpec {
  std::string name;                    ///< names it and its log, such as "view_planner2"
  std::vector<std::string> arguments;  ///< the program's path first
};

/// A process that has ended.
struct Departure {
  std::string name;
  int exit_code = 0;  ///< of one that left by itself
  int signal = 0;     ///< that ended it; 0: it left by itself

  bool orderly() const { return signal == 0 && exit_code == 0; }
  /// "died (SIGSEGV)", "exited with 2"
  std::string how() const;
};

/// Starts processes, each with what it says in <logs>/<name>.log, and knows when they end. They are in
/// process groups of their own, so that Ctrl-C reaches this process alone, and are killed by the kernel
/// should this process vanish.
class Supervisor {
 public:
  explicit Supervisor(std::string logs_folder);
  /// Kills what still runs.
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// @throws std::system_error if the program cannot be started
  void Start(const ProcessSpec& process);

  /// Those that have ended since the last call.
  std::vector<Departure> TakeDepartures();

  bool runs(const std::string& name) const { return running_.contains(name); }
  std::vector<std::string> running() const;

  void Signal(const std::string& name, int signal) const;
  void SignalAllBut(const std::string& name, int signal) const;

  /// The end of what a process has said.
  std::string LastWords(const std::string& name, int num_lines) const;
  std::string LogFile(const std::string& name) const;

 private:
  std::string logs_folder_;
  std::map<std::string, pid_t> running_;
};

}  // namespace citrine
