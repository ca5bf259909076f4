#include "modules/runtime/log_writer.h"

#include <stdexcept>

#include "modules/runtime/log_format.h"

namespace citrine {
namespace {

template <class Integer>
void Append(std::string& out, Integer value) {
  for (int shift = 8 * (static_cast<int>(sizeof value) - 1); shift >= 0; shift -= 8)
    out.push_back(static_cast<char>(value >> shift & 0xff));
}

}  // namespace

LogWriter::LogWriter(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  if (!file_) throw std::runtime_error("cannot write the log '" + path + "'");
}

void LogWriter::Write(const LogEvent& event) {
  std::string out;
  out.reserve(log_format::kHeaderBytes + event.channel.size());
  Append(out, log_format::kSync);
  Append(out, num_events_++);
  Append(out, event.utime());
  Append(out, static_cast<std::uint32_t>(event.channel.size()));
  Append(out, static_cast<std::uint32_t>(event.bytes.size()));
  out += event.channel;
  file_.write(out.data(), static_cast<std::streamsize>(out.size()));
  file_.write(reinterpret_cast<const char*>(event.bytes.data()),
              static_cast<std::streamsize>(event.bytes.size()));
  if (!file_) throw std::runtime_error("cannot write the log '" + path_ + "': is the disk full?");
}

void LogWriter::Flush() {
  if (!file_.flush()) throw std::runtime_error("cannot write the log '" + path_ + "': is the disk full?");
}

}  // namespace citrine
