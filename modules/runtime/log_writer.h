#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "modules/runtime/log_event.h"

namespace citrine {

/// Writes an LCM log, which all of LCM's tools read, with mission time as the time of every event.
class LogWriter {
 public:
  /// @throws std::runtime_error if the file cannot be written
  explicit LogWriter(const std::string& path);

  /// Appends an event, in the order of the calls. @throws std::runtime_error if the disk is full
  void Write(const LogEvent& event);
  /// Everything so far is on its way to the disk. @throws std::runtime_error if it is full
  void Flush();

  std::int64_t num_events() const { return num_events_; }

 private:
  std::string path_;
  std::ofstream file_;
  std::int64_t num_events_ = 0;
};

}  // namespace citrine
