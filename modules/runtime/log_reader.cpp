#include "modules/runtime/log_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "modules/channels.h"
#include "modules/runtime/log_format.h"
#include "modules/runtime/log_writer.h"
#include "modules/runtime/transport.h"

namespace citrine {
namespace {

template <class Integer>
Integer Parse(const std::array<unsigned char, log_format::kHeaderBytes>& header, std::size_t at) {
  Integer value = 0;
  for (std::size_t i = at; i < at + sizeof value; ++i) value = static_cast<Integer>(value << 8 | header[i]);
  return value;
}

bool HasManySenders(const std::string& channel) {
  return channel == channels::kStepDone.name || channel == channels::kFleetAssignment.name ||
         channel == channels::kModuleHealth.name;
}

std::int64_t CountMissing(const std::vector<LogEvent>& events) {
  std::map<std::string, SeqTrack> tracks;
  std::int64_t missing = 0;
  for (const LogEvent& event : events)
    if (!HasManySenders(event.channel))
      missing += tracks[event.channel].Advance(event.utime(), event.seq()).lost;
  return missing;
}

}  // namespace

LogReader::LogReader(const std::string& path) : files_(LogFiles(path)) {
  if (files_.empty()) throw std::runtime_error("cannot read the log '" + path + "'");
  Open(0);
}

void LogReader::Open(std::size_t file) {
  reading_ = file;
  file_ = std::ifstream(files_[file], std::ios::binary | std::ios::ate);
  if (!file_) throw std::runtime_error("cannot read the log '" + files_[file] + "'");
  size_ = file_.tellg();
  at_ = 0;
}

std::optional<LogEvent> LogReader::Next() {
  for (;;) {
    if (auto event = NextOfFile()) return event;
    if (reading_ + 1 == files_.size()) return std::nullopt;
    Open(reading_ + 1);
  }
}

std::optional<LogEvent> LogReader::NextOfFile() {
  const std::streamoff start = at_;
  do {
    if (auto event = ReadAt(at_)) {
      if (at_ != start) damages_.push_back({files_[reading_], start, at_ - start});
      at_ = file_.tellg();
      return event;
    }
  } while (SkipToSync());
  if (start != size_) damages_.push_back({files_[reading_], start, size_ - start});
  at_ = size_;
  return std::nullopt;
}

std::optional<LogEvent> LogReader::ReadAt(std::streamoff at) {
  std::array<unsigned char, log_format::kHeaderBytes> header;
  file_.clear();
  file_.seekg(at);
  if (!file_.read(reinterpret_cast<char*>(header.data()), header.size())) return std::nullopt;
  const auto channel_size = Parse<std::uint32_t>(header, 20);
  const auto data_size = Parse<std::uint32_t>(header, 24);
  if (Parse<std::uint32_t>(header, 0) != log_format::kSync || channel_size == 0 ||
      channel_size > log_format::kMaxChannelBytes || data_size > log_format::kMaxDataBytes)
    return std::nullopt;
  LogEvent event;
  event.time = static_cast<Utime>(Parse<std::uint64_t>(header, 12));
  event.channel.resize(channel_size);
  event.bytes.resize(data_size);
  file_.read(event.channel.data(), channel_size);
  if (!file_.read(reinterpret_cast<char*>(event.bytes.data()), data_size)) return std::nullopt;
  return event;
}

bool LogReader::SkipToSync() {
  file_.clear();
  file_.seekg(at_ + 1);
  std::uint32_t word = 0;
  for (int c; (c = file_.get()) != std::char_traits<char>::eof();) {
    word = word << 8 | static_cast<std::uint32_t>(c);
    if (word != log_format::kSync) continue;
    at_ = static_cast<std::streamoff>(file_.tellg()) - 4;
    return true;
  }
  return false;
}

std::vector<LogEvent> ReadInOrder(const std::string& path, RecordingFlaws* flaws) {
  LogReader reader(path);
  std::vector<LogEvent> events;
  while (auto event = reader.Next())
    if (!IsOfTheBus(event->channel)) events.push_back(std::move(*event));
  std::sort(events.begin(), events.end());
  const auto repeated = std::unique(events.begin(), events.end());
  const std::int64_t num_repeated = events.end() - repeated;
  events.erase(repeated, events.end());
  if (flaws) *flaws = {reader.damaged(), num_repeated, CountMissing(events)};
  return events;
}

std::int64_t PutInOrder(const std::string& recording, const std::string& log, RecordingFlaws* flaws,
                        const LogSplit& split) {
  const std::vector<LogEvent> events = ReadInOrder(recording, flaws);
  LogWriter writer(log, split);
  for (const LogEvent& event : events) writer.Write(event);
  writer.Flush();
  return writer.num_events();
}

}  // namespace citrine
