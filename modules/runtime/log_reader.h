#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "modules/runtime/log_event.h"

namespace citrine {

/// Reads an LCM log event by event, past damaged places.
class LogReader {
 public:
  /// @throws std::runtime_error if the file cannot be read
  explicit LogReader(const std::string& path);

  /// @return nullopt at the end
  std::optional<LogEvent> Next();

  /// Places at which something was skipped to reach the next event, or the log ended within one.
  std::int64_t damaged() const { return damaged_; }

 private:
  std::optional<LogEvent> ReadAt(std::streamoff at);
  /// Moves on to the next sync word behind `at_`. @return false if there is none
  bool SkipToSync();

  std::ifstream file_;
  std::streamoff size_ = 0, at_ = 0;
  std::int64_t damaged_ = 0;
};

/// What a recording held besides the mission.
struct RecordingFlaws {
  std::int64_t damaged = 0;   ///< places that were skipped
  std::int64_t repeated = 0;  ///< messages that were recorded twice, as the lockstep repeats what may be lost
  std::int64_t missing = 0;   ///< gaps in seq on channels with one sender: what the recorder did not hear
};

/// The whole recording in canonical order (LogEvent), without repetitions and without what the bus says of
/// itself (LCM_SELF_TEST, BUS_PROBE). A log that lcm-logger took of a lockstep mission becomes what one
/// process would have written.
std::vector<LogEvent> ReadInOrder(const std::string& path, RecordingFlaws* flaws = nullptr);

/// As above, from file to file. @return how many events were written
std::int64_t PutInOrder(const std::string& recording, const std::string& log,
                        RecordingFlaws* flaws = nullptr);

}  // namespace citrine
