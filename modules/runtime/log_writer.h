#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

#include "modules/runtime/log_event.h"
#include "modules/runtime/log_parts.h"

namespace citrine {

/// Writes an LCM log, which all of LCM's tools read, with mission time as the time of every event. Of a split
/// log every part begins with what is flown (MISSION_CONFIG), so that it explains itself.
class LogWriter {
 public:
  /// @throws std::runtime_error if the file cannot be written
  explicit LogWriter(const std::string& path, const LogSplit& split = {});

  /// Appends an event, in the order of the calls. @throws std::runtime_error if the disk is full
  void Write(const LogEvent& event);
  /// Everything so far is on its way to the disk. @throws std::runtime_error if it is full
  void Flush();

  /// In all parts, repetitions of MISSION_CONFIG at their beginnings apart.
  std::int64_t num_events() const { return num_written_; }

 private:
  void Open(const std::string& path);
  void Append(const LogEvent& event);
  void BeginPart();

  std::string name_, path_;
  LogSplit split_;
  std::ofstream file_;
  int part_ = 0;
  std::int64_t num_events_ = 0, bytes_ = 0;  ///< in this part
  std::int64_t num_written_ = 0;
  std::optional<LogEvent> flown_;
};

}  // namespace citrine
