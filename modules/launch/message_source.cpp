#include "modules/launch/message_source.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "modules/launch/bus_checks.h"
#include "modules/launch/running_mission.h"
#include "modules/runtime/log_reader.h"
#include "modules/runtime/transport.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr int kLook_ms = 100;

}  // namespace

std::string FindLog(const std::string& folder_or_log) {
  const std::string log =
      fs::is_directory(folder_or_log) ? (fs::path(folder_or_log) / "mission.lcmlog").string() : folder_or_log;
  if (LogFiles(log).empty()) throw std::runtime_error(log + ": there is no such log");
  return log;
}

std::string FindBus(const SourceOptions& options) {
  const std::string url = !options.run.empty()  ? EnterRunningMission(options.run)
                          : options.url.empty() ? DefaultBusUrl()
                                                : options.url;
  RequireHeard(url);
  return url;
}

void HearLog(const std::string& log, const std::function<void(const LogEvent&)>& hear) {
  LogReader reader(log);
  while (const auto event = reader.Next())
    if (!IsOfTheBus(event->channel)) hear(*event);
  if (reader.damaged() > 0)
    std::fprintf(stderr,
                 "citrine: %lld damaged places of the log were skipped; ./citrine log check names them\n",
                 static_cast<long long>(reader.damaged()));
}

void HearBus(const SourceOptions& options, const std::string& url,
             const std::function<void(const LogEvent&)>& hear, const std::function<bool()>& look) {
  Transport transport(url);
  const auto everything =
      transport.Subscribe(".*", 0, [&](const std::string& channel, const void* bytes, int size) {
        if (IsOfTheBus(channel)) return;
        const auto* first = static_cast<const std::uint8_t*>(bytes);
        hear({0, channel, {first, first + size}});
      });
  transport.CheckHearsItself();
  while (look() && (options.run.empty() || MissionRuns(options.run))) transport.Handle(kLook_ms);
}

}  // namespace citrine
