#pragma once

#include <string>

#include <sys/types.h>

namespace citrine {

/// Marks a result folder as that of a mission under way for as long as this object, or its process, lives:
/// the file `running` holds the URL of its bus and is locked.
class RunningMission {
 public:
  /// @throws std::runtime_error if another mission flies into the folder
  RunningMission(const std::string& folder, const std::string& url);
  ~RunningMission();
  RunningMission(const RunningMission&) = delete;
  RunningMission& operator=(const RunningMission&) = delete;

 private:
  std::string file_;
  int fd_;
};

/// The bus of the mission that flies into a folder, and the process that launched it.
struct MissionBus {
  std::string url;
  pid_t launcher = 0;
};
/// @throws std::runtime_error, with what to do about it, if none flies into it
MissionBus FindRunningMission(const std::string& folder);

/// Whether a mission flies into a folder.
bool MissionRuns(const std::string& folder);

/// Moves this process, before its first thread, into the network of the mission that flies into `folder`, be
/// it isolated or not. @return the URL of its bus
/// @throws std::runtime_error if none flies into it, it flies in one process, or the way in is refused
std::string EnterRunningMission(const std::string& folder);

}  // namespace citrine
