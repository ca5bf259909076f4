#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "modules/launch/commands.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/traffic_table.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {
namespace {

constexpr double kRecent_s = 5;  ///< over which rates are taken
constexpr double kRedraw_s = 0.5;
constexpr double kOnce_s = 3;  ///< listened to where there is no terminal
constexpr const char* kClear = "\033[H\033[J";

std::string Heading(const Traffic& traffic, double now_s, const std::string& url) {
  Traffic::Rate sum;
  std::int64_t lost = 0;
  for (const auto& [channel, said] : traffic.channels()) {
    const Traffic::Rate rate = traffic.RateAt(now_s, said);
    sum.messages_hz += rate.messages_hz;
    sum.bytes_per_s += rate.bytes_per_s;
    lost += said.lost;
  }
  char text[160];
  std::snprintf(text, sizeof text, "%zu channels, %.0f messages/s, %.1f kB/s, %lld lost  ",
                traffic.channels().size(), sum.messages_hz, sum.bytes_per_s / 1e3,
                static_cast<long long>(lost));
  return text + url + "\n";
}

int ShowLog(const std::string& log) {
  Traffic traffic;
  HearLog(log, [&](const LogEvent& event) { traffic.Hear(event.channel, event.bytes, Seconds(event.time)); });
  std::fputs(LogTable(traffic).c_str(), stdout);
  return kCompleted;
}

}  // namespace

int Top(const SourceOptions& source, double seconds) {
  if (!source.log.empty()) return ShowLog(FindLog(source.log));
  const std::string url = FindBus(source);
  const bool terminal = isatty(STDOUT_FILENO) && seconds == 0;
  const double end_s = seconds > 0 ? seconds : kOnce_s;
  CountInterrupts();
  Traffic traffic(kRecent_s);
  const Stopwatch since;
  const auto now_s = [&] { return since.ms() / 1e3; };
  double next_s = 0;
  const auto draw = [&](std::size_t columns, std::size_t rows) {
    std::string table = Heading(traffic, now_s(), url) + LiveTable(traffic, now_s(), columns, rows);
    if (traffic.channels().empty()) table += "nothing is said on this bus yet\n";
    std::fputs(((terminal ? kClear : "") + table).c_str(), stdout);
    std::fflush(stdout);
  };
  HearBus(
      source, url, [&](const LogEvent& event) { traffic.Hear(event.channel, event.bytes, now_s()); },
      [&] {
        if (terminal && now_s() >= next_s) {
          winsize size{};
          ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
          draw(size.ws_col, size.ws_row > 3 ? size.ws_row - 2u : 0u);
          next_s = now_s() + kRedraw_s;
        }
        return Interrupts() == 0 && (terminal || now_s() < end_s);
      });
  if (!terminal) draw(0, 0);
  return kCompleted;
}

}  // namespace citrine
