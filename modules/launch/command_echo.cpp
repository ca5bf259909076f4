#include <cstdio>
#include <regex>
#include <set>

#include "core/config/nearest_name.h"
#include "modules/codec/bad_message.h"
#include "modules/launch/commands.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/traffic_table.h"
#include "modules/reflection/message_text.h"
#include "modules/reflection/message_types.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {
namespace {

constexpr double kPatience_s = 3;  ///< in which nothing is said of a channel that is silent

/// Prints the messages of the channels that match, and remembers which others there are.
class Echo {
 public:
  explicit Echo(const EchoOptions& options) : options_(options), wanted_(Pattern(options.channel)) {}

  void Hear(const LogEvent& event) {
    channels_.insert(event.channel);
    if (done() || !std::regex_match(event.channel, wanted_)) return;
    ++heard_;
    Print(event);
  }
  bool done() const { return options_.count > 0 && heard_ >= options_.count; }
  bool heard_any() const { return heard_ > 0; }

  std::string Silence(const char* where) const {
    if (channels_.empty()) return std::string("nothing at all is said ") + where;
    const std::string nearest = NearestName(options_.channel, {channels_.begin(), channels_.end()});
    std::string text =
        "nothing is said on " + options_.channel + " " + where + "; did you mean " + nearest + "? Heard:";
    for (const std::string& channel : channels_) text += " " + channel;
    return text;
  }

 private:
  static std::regex Pattern(const std::string& channel) {
    try {
      return std::regex(channel);
    } catch (const std::regex_error&) {
      throw std::runtime_error(channel + ": neither a channel nor a regular expression of channels");
    }
  }

  void Print(const LogEvent& event) {
    const MessageType* type = TypeOf(event.bytes);
    try {
      Require(type, "no type of ours");
      const std::vector<FieldValues> fields = ReadFields(*type, event.bytes);
      const std::string text = options_.json
                                   ? "{\"channel\":" + JsonText(event.channel) + ",\"type\":\"" + type->name +
                                         "\"," + ToJsonMembers(fields) + "}\n"
                                   : event.channel + "  " + type->name + "  t " +
                                         MissionTimeText(event.utime()) + "\n" + ToText(*type, fields);
      std::fputs(text.c_str(), stdout);
    } catch (const BadMessage& error) {
      std::fprintf(stderr, "%s: %zu bytes that do not decode: %s\n", event.channel.c_str(),
                   event.bytes.size(), error.what());
    }
    std::fflush(stdout);
  }

  EchoOptions options_;
  std::regex wanted_;
  std::set<std::string> channels_;
  int heard_ = 0;
};

}  // namespace

int EchoChannel(const EchoOptions& options) {
  Echo echo(options);
  if (!options.source.log.empty()) {
    HearLog(FindLog(options.source.log), [&](const LogEvent& event) { echo.Hear(event); });
    if (!echo.heard_any()) std::fprintf(stderr, "citrine: %s\n", echo.Silence("in this log").c_str());
    return echo.heard_any() ? kCompleted : kSetUpProblem;
  }
  const std::string url = FindBus(options.source);
  CountInterrupts();
  const Stopwatch since;
  bool told = false;
  HearBus(
      options.source, url, [&](const LogEvent& event) { echo.Hear(event); },
      [&] {
        if (!echo.heard_any() && !told && since.ms() > kPatience_s * 1e3) {
          std::fprintf(stderr, "citrine: %s; listening on\n", echo.Silence("yet").c_str());
          told = true;
        }
        return Interrupts() == 0 && !echo.done();
      });
  return kCompleted;
}

}  // namespace citrine
