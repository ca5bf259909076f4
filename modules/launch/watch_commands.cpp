#include "modules/launch/watch_commands.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "modules/launch/commands.h"

namespace citrine {
namespace {

void AddBus(CLI::App& app, SourceOptions& source) {
  auto* run =
      app.add_option("--run", source.run, "Result folder of a mission under way, isolated or not: its bus")
          ->type_name("DIR");
  app.add_option("-l,--lcm-url", source.url, "LCM provider; default: LCM_DEFAULT_URL, else LCM's own group")
      ->type_name("URL")
      ->excludes(run);
}

void AddTop(CLI::App& app, int& exit_code) {
  auto source = std::make_shared<SourceOptions>();
  auto seconds = std::make_shared<double>(0);
  CLI::App* top = app.add_subcommand("top", "Channels of a bus or a log: type, rate, bytes, lost, age");
  top->add_option("log", source->log, "A log or result folder; without one, the bus")->type_name("RUN|LOG");
  AddBus(*top, *source);
  top->add_option("--seconds", *seconds,
                  "Listen so long and print once; default on a terminal: redraw until Ctrl-C")
      ->check(CLI::PositiveNumber);
  top->final_callback([=, &exit_code] { exit_code = Top(*source, *seconds); });
}

void AddSpy(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SpyOptions>();
  CLI::App* spy = app.add_subcommand("spy", "lcm-spy with this project's types, and the mission from above");
  AddBus(*spy, options->source);
  auto* screenshot =
      spy->add_option("--screenshot", options->screenshot, "Save the screen and end")->type_name("FILE.png");
  spy->add_option("--after", options->screenshot_after_s, "Seconds before that; 5 by default")
      ->check(CLI::PositiveNumber)
      ->needs(screenshot);
  spy->final_callback([=, &exit_code] { exit_code = Spy(*options); });
}

void AddEcho(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<EchoOptions>();
  CLI::App* echo = app.add_subcommand("echo", "Messages of a channel, decoded, from a bus or a log");
  echo->add_option("channel", options->channel, "A channel, or a regular expression: 'UAV[12]_PATH'")
      ->required()
      ->type_name("CHANNEL");
  echo->add_option("log", options->source.log, "A log or result folder; without one, the bus")
      ->type_name("RUN|LOG");
  AddBus(*echo, options->source);
  echo->add_option("--count", options->count, "End after so many")->check(CLI::PositiveNumber);
  echo->add_flag("--json", options->json, "One line of JSON a message");
  echo->final_callback([=, &exit_code] { exit_code = EchoChannel(*options); });
}

void AddLog(CLI::App& app, int& exit_code) {
  CLI::App* log = app.add_subcommand("log", "What a recording holds; a piece of it; what is wrong with it");
  log->require_subcommand(1);
  auto path = std::make_shared<std::string>();
  CLI::App* info = log->add_subcommand("info", "Duration, mission, commit, channels, rates, gaps");
  info->add_option("log", *path, "A log or result folder")->required()->type_name("RUN|LOG");
  info->final_callback([=, &exit_code] { exit_code = LogInfo(*path); });
  CLI::App* check =
      log->add_subcommand("check", "Damage, gaps, what does not decode; ends with 3 if there is any");
  check->add_option("log", *path, "A log or result folder")->required()->type_name("RUN|LOG");
  check->final_callback([=, &exit_code] { exit_code = LogCheck(*path); });
  auto cut = std::make_shared<CutOptions>();
  CLI::App* piece = log->add_subcommand("cut", "Write a piece: some time, some channels");
  piece->add_option("log", cut->log, "A log or result folder")->required()->type_name("RUN|LOG");
  piece->add_option("out", cut->to, "The log to write")->required()->type_name("OUT");
  piece->add_option("--from", cut->from_s, "Mission time at which it begins")->type_name("SECONDS");
  piece->add_option("--to", cut->to_s, "Mission time at which it ends")->type_name("SECONDS");
  piece->add_option("--channels", cut->channels, "A regular expression: 'UAV1_.*|CLOCK'")->type_name("REGEX");
  piece->final_callback([=, &exit_code] { exit_code = LogCut(*cut); });
}

}  // namespace

void AddWatchCommands(CLI::App& app, int& exit_code) {
  AddSpy(app, exit_code);
  AddTop(app, exit_code);
  AddEcho(app, exit_code);
  AddLog(app, exit_code);
}

}  // namespace citrine
