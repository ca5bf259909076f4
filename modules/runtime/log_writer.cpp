#include "modules/runtime/log_writer.h"

#include <filesystem>
#include <stdexcept>

#include "modules/channels.h"
#include "modules/runtime/log_format.h"

namespace citrine {
namespace {

template <class Integer>
void AppendNumber(std::string& out, Integer value) {
  for (int shift = 8 * (static_cast<int>(sizeof value) - 1); shift >= 0; shift -= 8)
    out.push_back(static_cast<char>(value >> shift & 0xff));
}

}  // namespace

LogWriter::LogWriter(const std::string& path, const LogSplit& split) : name_(path), split_(split) {
  Open(split_.part_bytes > 0 ? LogPart(name_, 0) : name_);
}

void LogWriter::Open(const std::string& path) {
  path_ = path;
  file_.open(path, std::ios::binary);
  if (!file_) throw std::runtime_error("cannot write the log '" + path + "'");
  num_events_ = bytes_ = 0;
}

void LogWriter::Write(const LogEvent& event) {
  if (split_.part_bytes > 0 && bytes_ >= split_.part_bytes) BeginPart();
  if (split_.part_bytes > 0 && event.channel == channels::kMissionConfig.name) flown_ = event;
  Append(event);
  ++num_written_;
}

void LogWriter::BeginPart() {
  Flush();
  file_.close();
  ++part_;
  if (split_.keep > 0 && part_ >= split_.keep) std::filesystem::remove(LogPart(name_, part_ - split_.keep));
  Open(LogPart(name_, part_));
  if (flown_) Append(*flown_);
}

void LogWriter::Append(const LogEvent& event) {
  std::string out;
  out.reserve(log_format::kHeaderBytes + event.channel.size());
  AppendNumber(out, log_format::kSync);
  AppendNumber(out, num_events_++);
  AppendNumber(out, event.utime());
  AppendNumber(out, static_cast<std::uint32_t>(event.channel.size()));
  AppendNumber(out, static_cast<std::uint32_t>(event.bytes.size()));
  out += event.channel;
  file_.write(out.data(), static_cast<std::streamsize>(out.size()));
  file_.write(reinterpret_cast<const char*>(event.bytes.data()),
              static_cast<std::streamsize>(event.bytes.size()));
  if (!file_) throw std::runtime_error("cannot write the log '" + path_ + "': is the disk full?");
  bytes_ += static_cast<std::int64_t>(out.size() + event.bytes.size());
}

void LogWriter::Flush() {
  if (!file_.flush()) throw std::runtime_error("cannot write the log '" + path_ + "': is the disk full?");
}

}  // namespace citrine
