#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "modules/runtime/log_event.h"
#include "modules/runtime/log_parts.h"

namespace citrine {

/// Reads an LCM log, one file or its parts (LogFiles), event by event, past damaged places.
class LogReader {
 public:
  /// A place at which something was skipped to reach the next event, or a file ended within one.
  struct Damage {
    std::string file;
    std::int64_t at = 0;     ///< byte
    std::int64_t bytes = 0;  ///< skipped
  };

  /// @throws std::runtime_error if there is no such log, or it cannot be read
  explicit LogReader(const std::string& path);

  /// @return nullopt at the end
  std::optional<LogEvent> Next();

  /// Places found so far.
  std::int64_t damaged() const { return static_cast<std::int64_t>(damages_.size()); }
  const std::vector<Damage>& damages() const { return damages_; }

 private:
  void Open(std::size_t file);
  std::optional<LogEvent> NextOfFile();
  std::optional<LogEvent> ReadAt(std::streamoff at);
  /// Moves on to the next sync word behind `at_`. @return false if there is none
  bool SkipToSync();

  std::vector<std::string> files_;
  std::size_t reading_ = 0;  ///< which of them
  std::ifstream file_;
  std::streamoff size_ = 0, at_ = 0;
  std::vector<Damage> damages_;
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

/// As above, from file to file, or from parts to parts. @return how many events were written
std::int64_t PutInOrder(const std::string& recording, const std::string& log, RecordingFlaws* flaws = nullptr,
                        const LogSplit& split = {});

}  // namespace citrine
