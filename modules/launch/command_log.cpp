#include <cstdio>
#include <filesystem>
#include <regex>

#include "modules/channels.h"
#include "modules/codec/clock.h"
#include "modules/codec/mission_config_text.h"
#include "modules/launch/commands.h"
#include "modules/launch/traffic_table.h"
#include "modules/runtime/log_reader.h"
#include "modules/runtime/log_writer.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFindings = 20;  ///< of a kind, that are printed one by one

template <class Message>
auto DecodeEvent(const LogEvent& event) -> std::optional<decltype(Decode(Message{}))> {
  try {
    Message message{};
    if (message.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size())) ==
        static_cast<int>(event.bytes.size()))
      return Decode(message);
  } catch (const std::exception&) {  // counted as undecodable by Traffic
  }
  return std::nullopt;
}

/// What a log says of the mission that it was taken of.
struct Story {
  std::optional<MissionConfigText> flown;
  std::optional<Clock> last_clock;

  void Hear(const LogEvent& event) {
    if (event.channel == channels::kMissionConfig.name) {
      if (auto config = DecodeEvent<citrine_lcm::mission_config_t>(event)) flown = std::move(config);
    } else if (event.channel == channels::kClock.name) {
      if (auto clock = DecodeEvent<citrine_lcm::clock_t>(event)) last_clock = std::move(clock);
    }
  }
  std::string Text() const {
    if (!flown) return "mission: not said (no MISSION_CONFIG in it)\n";
    std::string text = "mission: " + flown->mission_id +
                       "\ncommit: " + (flown->commit.empty() ? "not known" : flown->commit) +
                       (flown->dirty ? ", with changes of its own" : "") + "\n";
    for (const std::string& override_text : flown->overrides) text += "set: " + override_text + "\n";
    return text + "its whole configuration: ./citrine echo MISSION_CONFIG LOG --count 1\n";
  }
  std::string End() const {
    if (!last_clock) return "end: no CLOCK in it";
    if (last_clock->state != Clock::State::kDone) return "end: the mission was still under way";
    return "end: " + last_clock->reason;
  }
};

/// Findings of `log check`: the first few in words, all of them counted.
class Findings {
 public:
  void Add(const std::string& what) {
    if (++count_ <= kMostFindings) std::printf("  %s\n", what.c_str());
    if (count_ == kMostFindings + 1) std::printf("  ... and more\n");
  }
  std::int64_t count() const { return count_; }

 private:
  std::int64_t count_ = 0;
};

void CheckEvents(LogReader& reader, Traffic& traffic, Story& story, Findings& findings) {
  while (const auto event = reader.Next()) {
    if (IsOfTheBus(event->channel)) continue;
    story.Hear(*event);
    const Traffic::Heard heard = traffic.Hear(event->channel, event->bytes, Seconds(event->time));
    const std::string where = event->channel + " at " + MissionTimeText(event->utime());
    if (heard.lost > 0)
      findings.Add(where + ": " + std::to_string(heard.lost) + " messages before it are missing");
    if (!heard.bad.empty()) findings.Add(event->channel + ": does not decode: " + heard.bad);
  }
  for (const LogReader::Damage& damage : reader.damages())
    findings.Add(damage.file + " at byte " + std::to_string(damage.at) + ": " + std::to_string(damage.bytes) +
                 " damaged bytes skipped");
}

}  // namespace

int LogInfo(const std::string& folder_or_log) {
  const std::string log = FindLog(folder_or_log);
  LogReader reader(log);
  Traffic traffic;
  Story story;
  std::int64_t events = 0;
  while (const auto event = reader.Next()) {
    if (IsOfTheBus(event->channel)) continue;
    ++events;
    story.Hear(*event);
    traffic.Hear(event->channel, event->bytes, Seconds(event->time));
  }
  std::uintmax_t bytes = 0;
  const auto files = LogFiles(log);
  for (const std::string& file : files) bytes += fs::file_size(file);
  std::int64_t lost = 0, bad = 0;
  Utime last = 0;
  for (const auto& [channel, said] : traffic.channels()) {
    lost += said.lost;
    bad += said.bad;
    last = std::max(last, said.last);
  }
  std::printf("%s: %.1f MB in %zu file%s, %lld events, until %s of mission time\n", log.c_str(),
              static_cast<double>(bytes) / 1e6, files.size(), files.size() == 1 ? "" : "s",
              static_cast<long long>(events), MissionTimeText(last).c_str());
  std::fputs(story.Text().c_str(), stdout);
  std::printf("%s\n%lld damaged places skipped, %lld messages missing, %lld that do not decode\n\n%s",
              story.End().c_str(), static_cast<long long>(reader.damaged()), static_cast<long long>(lost),
              static_cast<long long>(bad), LogTable(traffic).c_str());
  return kCompleted;
}

int LogCheck(const std::string& folder_or_log) {
  LogReader reader(FindLog(folder_or_log));
  Traffic traffic;
  Story story;
  Findings findings;
  CheckEvents(reader, traffic, story, findings);
  if (!story.flown) findings.Add("no MISSION_CONFIG: it does not say what was flown");
  if (!story.last_clock || story.last_clock->state != Clock::State::kDone) findings.Add(story.End());
  if (findings.count() == 0)
    std::printf("sound; %s\n", story.End().c_str());
  else
    std::printf("found: %lld\n", static_cast<long long>(findings.count()));
  return findings.count() == 0 ? kCompleted : kNotCompleted;
}

int LogCut(const CutOptions& options) {
  const std::string log = FindLog(options.log);
  if (!LogFiles(options.to).empty()) throw std::runtime_error(options.to + ": there is such a log already");
  const std::regex wanted(options.channels.empty() ? ".*" : options.channels);
  LogReader reader(log);
  LogWriter writer(options.to);
  std::optional<LogEvent> flown;  // what is flown belongs to every piece
  while (const auto event = reader.Next()) {
    const double at_s = Seconds(event->utime());
    const bool is_config = event->channel == channels::kMissionConfig.name;
    if (IsOfTheBus(event->channel) || (options.to_s && at_s > *options.to_s)) continue;
    if (options.from_s && at_s < *options.from_s) {
      if (is_config) flown = event;
      continue;
    }
    if (flown) writer.Write(*std::exchange(flown, std::nullopt));
    if (is_config || std::regex_match(event->channel, wanted)) writer.Write(*event);
  }
  writer.Flush();
  std::printf("%s: %lld events; %lld damaged places skipped\n", options.to.c_str(),
              static_cast<long long>(writer.num_events()), static_cast<long long>(reader.damaged()));
  return kCompleted;
}

}  // namespace citrine
