#include "modules/runtime/run_recorder.h"

#include <cstdio>
#include <optional>

#include <CLI/CLI.hpp>

#include "modules/runtime/log_writer.h"
#include "modules/runtime/quit_signals.h"
#include "modules/runtime/transport.h"

namespace citrine {
namespace {

constexpr int kLook_ms = 100;   // how often it looks for signals
constexpr int kQuiet_ms = 200;  // the bus is silent for so long: the last word has been said

int Fail(int code, const char* what) {
  std::fprintf(stderr, "recorder: %s\n", what);
  return code;
}

int Record(const std::string& url, const std::string& path, const LogSplit& split) {
  std::optional<LogWriter> log;
  std::optional<Transport> transport;
  std::unique_ptr<Transport::Subscription> everything;
  try {
    log.emplace(path, split);
    transport.emplace(url);
    everything = transport->Subscribe(".*", 0, [&](const std::string& channel, const void* bytes, int size) {
      if (IsOfTheBus(channel)) return;
      const auto* first = static_cast<const std::uint8_t*>(bytes);
      log->Write({0, channel, {first, first + size}});
    });
    transport->CheckHearsItself();
  } catch (const std::exception& error) {
    return Fail(2, error.what());
  }
  try {
    while (!Interrupted())
      if (transport->Handle(kLook_ms) == 0) log->Flush();
    while (transport->Handle(kQuiet_ms) > 0 && !Terminated()) continue;
    log->Flush();
    return 0;
  } catch (const std::exception& error) {
    return Fail(4, error.what());
  }
}

}  // namespace

int RunRecorder(int argc, char** argv) {
  CatchQuitSignals();
  std::string url = DefaultBusUrl(), path;
  LogSplit split;
  double split_mb = 0;
  CLI::App app{"Records all that is said on a bus.", "recorder"};
  app.add_option("-l,--lcm-url", url, "LCM provider")->capture_default_str();
  app.add_option("--split-mb", split_mb,
                 "Go on in a new part, LOG.000, LOG.001 ..., after so much; 0: one file")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--keep", split.keep, "Parts that are kept, the newest; 0: all")
      ->check(CLI::NonNegativeNumber);
  app.add_option("log", path, "The log to write")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return Fail(1, error.what());
  }
  split.part_bytes = static_cast<std::int64_t>(split_mb * 1e6);
  return Record(url, path, split);
}

}  // namespace citrine
