#include "modules/launch/running_mission.h"

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "running";

struct flock WholeFile(short type) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Who holds the lock; 0: nobody.
pid_t LauncherInto(const std::string& folder) {
  struct flock lock = WholeFile(F_WRLCK);
  const int fd = open((fs::path(folder) / kFile).c_str(), O_RDONLY | O_CLOEXEC);
  const bool runs = fd >= 0 && fcntl(fd, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  if (fd >= 0) close(fd);
  return runs ? lock.l_pid : 0;
}

/// A namespace that one is in already cannot be entered again; there is no need to.
void Join(pid_t pid, const std::string& kind, int flag) {
  const std::string theirs = "/proc/" + std::to_string(pid) + "/ns/" + kind;
  std::error_code unseen;
  if (fs::read_symlink(theirs, unseen) == fs::read_symlink("/proc/self/ns/" + kind, unseen) && !unseen)
    return;
  const int fd = open(theirs.c_str(), O_RDONLY | O_CLOEXEC);
  const bool joined = fd >= 0 && setns(fd, flag) == 0;
  const int error = errno;
  if (fd >= 0) close(fd);
  if (!joined)
    throw std::runtime_error("cannot enter the network of process " + std::to_string(pid) + ": " +
                             std::strerror(error) + "; be who started the mission, or root");
}

}  // namespace

RunningMission::RunningMission(const std::string& folder, const std::string& url)
    : file_((fs::path(folder) / kFile).string()),
      fd_(open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  struct flock lock = WholeFile(F_WRLCK);
  if (fd_ < 0 || fcntl(fd_, F_SETLK, &lock) != 0) {
    const bool taken = fd_ >= 0;
    if (taken) close(fd_);
    throw std::runtime_error(taken ? folder +
                                         ": another mission flies into this folder; choose another with --out"
                                   : file_ + ": cannot be written");
  }
  const std::string text = url + "\n";
  if (ftruncate(fd_, 0) != 0 || write(fd_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    close(fd_);
    throw std::runtime_error(file_ + ": cannot be written");
  }
}

RunningMission::~RunningMission() {
  unlink(file_.c_str());
  close(fd_);
}

MissionBus FindRunningMission(const std::string& folder) {
  const pid_t launcher = LauncherInto(folder);
  if (launcher == 0)
    throw std::runtime_error(folder +
                             ": no mission flies into this folder now; its recording can be read with: "
                             "./citrine log info " +
                             folder);
  MissionBus bus{{}, launcher};
  std::ifstream in(fs::path(folder) / kFile);
  std::getline(in, bus.url);
  return bus;
}

bool MissionRuns(const std::string& folder) { return LauncherInto(folder) != 0; }

std::string EnterRunningMission(const std::string& folder) {
  const MissionBus bus = FindRunningMission(folder);
  if (bus.url.starts_with("memq"))
    throw std::runtime_error(folder +
                             ": this mission flies in one process, and nobody else hears its bus; fly it in "
                             "processes of their own (without --in-process)");
  Join(bus.launcher, "user", CLONE_NEWUSER);
  Join(bus.launcher, "net", CLONE_NEWNET);
  return bus.url;
}

}  // namespace citrine
