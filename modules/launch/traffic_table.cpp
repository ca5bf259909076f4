#include "modules/launch/traffic_table.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "modules/channels.h"

namespace citrine {
namespace {

template <class... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

int WidthOf(const Traffic& traffic) {
  std::size_t width = 7;
  for (const auto& [channel, said] : traffic.channels()) width = std::max(width, channel.size());
  return static_cast<int>(std::min<std::size_t>(width, 63));
}

std::string CountOrDash(std::int64_t count) { return count > 0 ? std::to_string(count) : "-"; }

}  // namespace

std::string MissionTimeText(Utime utime) {
  const auto ms = static_cast<long long>(utime / 1000);
  return Format("%02lld:%02lld.%03lld", ms / 60000, ms / 1000 % 60, ms % 1000);
}

std::string LiveTable(const Traffic& traffic, double now_s, std::size_t columns, std::size_t rows) {
  const int width = WidthOf(traffic);
  std::vector<std::string> lines = {Format("%-*s  %-20s %9s %9s %7s %5s %7s", width, "CHANNEL", "TYPE",
                                           "RATE /s", "kB/s", "LOST", "BAD", "AGE s")};
  for (const auto& [channel, said] : traffic.channels()) {
    const Traffic::Rate rate = traffic.RateAt(now_s, said);
    lines.push_back(Format("%-*s  %-20s %9.1f %9.2f %7s %5s %7.1f", width, channel.c_str(), said.type.c_str(),
                           rate.messages_hz, rate.bytes_per_s / 1e3, CountOrDash(said.lost).c_str(),
                           CountOrDash(said.bad).c_str(), now_s - said.last_s));
  }
  if (rows > 1 && lines.size() > rows) {
    lines.resize(rows - 1);
    lines.push_back("... a taller terminal shows " + std::to_string(traffic.channels().size() + 2 - rows) +
                    " more");
  }
  std::string text;
  for (const std::string& line : lines) text += line.substr(0, columns > 0 ? columns : line.size()) + "\n";
  return text;
}

std::string LogTable(const Traffic& traffic) {
  const int width = WidthOf(traffic);
  Utime first = 0, last = 0;
  for (const auto& [channel, said] : traffic.channels()) last = std::max(last, said.last);
  first = last;
  for (const auto& [channel, said] : traffic.channels())
    if (said.messages > said.bad && channel != channels::kMissionConfig.name)  // of a piece it is older
      first = std::min(first, said.first);
  const double over_s = std::max(Seconds(last - first), 1e-3);
  std::string text = Format("%-*s  %-20s %9s %9s %9s %7s %5s  %-9s  %s\n", width, "CHANNEL", "TYPE",
                            "MESSAGES", "RATE /s", "kB/s", "LOST", "BAD", "FIRST", "LAST");
  for (const auto& [channel, said] : traffic.channels())
    text +=
        Format("%-*s  %-20s %9lld %9.1f %9.2f %7s %5s  %-9s  %s\n", width, channel.c_str(), said.type.c_str(),
               static_cast<long long>(said.messages), static_cast<double>(said.messages) / over_s,
               static_cast<double>(said.bytes) / over_s / 1e3, CountOrDash(said.lost).c_str(),
               CountOrDash(said.bad).c_str(), MissionTimeText(said.first).c_str(),
               MissionTimeText(said.last).c_str());
  return text;
}

}  // namespace citrine
