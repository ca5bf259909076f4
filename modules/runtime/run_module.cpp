#include "modules/runtime/run_module.h"

#include <cstdio>
#include <fstream>
#include <sstream>

#include <CLI/CLI.hpp>

#include "core/config/config_file.h"
#include "modules/runtime/follow_clock.h"
#include "modules/runtime/own_clock.h"
#include "modules/runtime/quit_signals.h"

namespace citrine {
namespace {

struct Options {
  std::string url = DefaultBusUrl();
  std::string mission;
  std::vector<std::string> overrides;
  int uav = 0;
};

std::string ReadText(const std::string& path) {
  if (path.empty()) return {};
  std::ifstream file(path);
  if (!file) throw ConfigError("cannot read the mission file '" + path + "'");
  return (std::ostringstream() << file.rdbuf()).str();
}

MissionConfig ReadMission(const ModuleKind& kind, const Options& options) {
  const MissionConfig config = ParseMission(ReadText(options.mission), options.overrides);
  if (kind.per_uav && (options.uav < 1 || options.uav > config.mission.uavs))
    throw ConfigError("--uav must be 1.." + std::to_string(config.mission.uavs) + ", is " +
                      std::to_string(options.uav));
  if (!kind.per_uav && options.uav != 0) throw ConfigError("--uav: one " + kind.name + " serves all UAVs");
  return config;
}

int Fail(const ModuleKind& kind, int code, const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", kind.name.c_str(), what.c_str());
  return code;
}

int Fly(const ModuleKind& kind, const Options& options) {
  std::unique_ptr<HostedModule> module;
  try {
    const MissionConfig config = ReadMission(kind, options);
    const auto transport = std::make_shared<Transport>(options.url);
    transport->CheckHearsItself();
    module = std::make_unique<HostedModule>(kind, config, options.uav, transport);
  } catch (const std::exception& error) {
    return Fail(kind, 2, error.what());
  }
  try {
    if (kind.owns_time())
      OwnClock(*module);
    else
      FollowClock(*module);
    module->SayHealth(ModuleHealth::State::kDone);
    return 0;
  } catch (const std::exception& error) {
    return Fail(kind, 4, error.what());
  }
}

}  // namespace

int RunModule(const ModuleKind& kind, int argc, char** argv) {
  CatchQuitSignals();
  Options options;
  CLI::App app{kind.summary, kind.name};
  app.add_option("-l,--lcm-url", options.url, "LCM provider")->capture_default_str();
  app.add_option("-P,--mission", options.mission,
                 "Mission file (TOML); without one every key has its default");
  app.add_option("-O,--set", options.overrides, "section.key=value, instead of the file's; again for more")
      ->allow_extra_args(false);
  app.add_option("--uav", options.uav,
                 kind.per_uav ? "Which UAV to serve, 1..N" : "Not used here: one serves all");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return Fail(kind, 1, error.what());
  }
  return Fly(kind, options);
}

}  // namespace citrine
