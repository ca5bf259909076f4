#include <cstdio>
#include <exception>
#include <iterator>

#include <CLI/CLI.hpp>

#include "core/config/config_file.h"
#include "core/config/number_text.h"
#include "modules/launch/commands.h"
#include "modules/launch/sweep/sweep_command_line.h"
#include "modules/launch/watch_commands.h"

namespace citrine {
namespace {

/// "max" or a factor, as launch.pace has it.
std::string PaceOf(const std::string& text) {
  double factor = 0;
  if (text == "max") return "0";
  if (!CLI::detail::lexical_cast(text, factor) || !(factor > 0))
    throw CLI::ValidationError("--pace", "must be a factor above 0, or max; is " + text);
  return NumberText(factor);
}

struct RunCommand {
  RunOptions options;
  std::string strategy, uavs, seed, pace, out;
  std::vector<std::string> set;
  bool in_process = false, view = false, video = false;

  explicit RunCommand(CLI::App& app) {
    app.add_option("mission", options.mission, "A name in missions/, or a mission file")
        ->required()
        ->type_name("MISSION");
    app.add_option("--strategy", strategy, "Who decides")->type_name("NAME");
    app.add_option("--uavs", uavs, "UAVs in the fleet")->type_name("N")->check(CLI::Number);
    app.add_option("--seed", seed, "Of sensor noise, spawns and first centroids")
        ->type_name("K")
        ->check(CLI::Number);
    app.add_option("--pace", pace,
                   "Mission seconds a second of the wall, or max: lockstep, as fast as it goes")
        ->type_name("1|N|max");
    auto* in_process_flag =
        app.add_flag("--in-process", in_process, "All modules in one process, in lockstep");
    auto* isolate_flag =
        app.add_flag("--isolate", options.isolate, "In a private network")->excludes(in_process_flag);
    app.add_flag("--by-hand", options.by_hand,
                 "Record and report; the modules are started from other terminals")
        ->excludes(in_process_flag)
        ->excludes(isolate_flag);
    app.add_option("--world", options.world, "Another world than the mission's: SDFormat or a mesh")
        ->type_name("FILE");
    app.add_option("--map", options.map, "Go on from the map of an earlier mission over the same volume")
        ->type_name("DIR");
    app.add_option("--out", out, "Result folder; default results/<mission>-<strategy>-<seed>")
        ->type_name("DIR");
    app.add_flag("--view", view, "Show the top-down picture in a window");
    app.add_flag("--video", video, "Write topdown.mp4");
    app.add_option("--set", set, "Any key of the mission file")
        ->type_name("SECTION.KEY=VALUE")
        ->allow_extra_args(false);
  }

  RunOptions Parsed() const {
    RunOptions parsed = options;
    const auto set_key = [&](const char* key, const std::string& value) {
      if (!value.empty()) parsed.overrides.push_back(std::string(key) + "=" + value);
    };
    set_key("planner.strategy", strategy);
    set_key("mission.uavs", uavs);
    set_key("mission.seed", seed);
    set_key("launch.pace", pace.empty() ? "" : PaceOf(pace));
    set_key("launch.out", out);
    if (in_process) set_key("launch.in_process", "true");
    if (view) set_key("launch.view", "true");
    if (video) set_key("launch.video", "true");
    parsed.overrides.insert(parsed.overrides.end(), set.begin(), set.end());
    return parsed;
  }
};

struct ReplayCommand {
  ReplayOptions options;

  explicit ReplayCommand(CLI::App& app) {
    app.add_option("recording", options.log, "A log or result folder")->required()->type_name("RUN|LOG");
    auto* into =
        app.add_option("--into", options.into,
                       "Feed it into the real module and compare what that says; without: onto the bus")
            ->type_name("MODULE")
            ->check(CLI::IsMember(std::vector<std::string>(std::begin(kReplayable), std::end(kReplayable))));
    app.add_option(
           "--speed", options.speed,
           "Mission seconds a second of the wall; default 1 on the bus, as fast as it goes into a module")
        ->type_name("X")
        ->check(CLI::PositiveNumber);
    app.add_option("--out", options.out, "Where topdown_renderer writes its pictures")
        ->type_name("DIR")
        ->needs(into);
    app.add_flag("--view", options.view, "Of topdown_renderer: show the picture in a window")->needs(into);
    app.add_flag("--video", options.video, "Of topdown_renderer: write topdown.mp4")->needs(into);
  }
};

struct ExplainCommand {
  ExplainOptions options;

  explicit ExplainCommand(CLI::App& app) {
    app.add_option("recording", options.run, "A log or result folder")->required()->type_name("RUN|LOG");
    app.add_option("--uav", options.uav, "Whose decision")->required()->type_name("I");
    app.add_option("--decision", options.decision, "Which of its selections of a view, from 1")
        ->required()
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    app.add_option("--rows", options.rows, "Candidates listed at most; default 10")
        ->type_name("K")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--out", options.out, "Picture; default explain-uav<I>-<N>.png beside the log")
        ->type_name("FILE");
  }
};

struct FuseCommand {
  FuseOptions options;

  explicit FuseCommand(CLI::App& app) {
    app.add_option("--scans", options.scans,
                   "Clouds in the sensor frame, in order of name: .bin (KITTI), .ply, .pcd")
        ->required()
        ->type_name("DIR");
    app.add_option("--poses", options.poses, "Of the sensor: t x y z qx qy qz qw, a line a scan")
        ->required()
        ->type_name("FILE.tum");
    app.add_option("--out", options.out, "Where mesh.ply, map.bt and metrics.json go")
        ->required()
        ->type_name("DIR");
    app.add_option("--voxel", options.voxel_m, "Edge of a voxel")->type_name("METRES")->capture_default_str();
    app.add_option("--truncation", options.truncation_m,
                   "Band on either side of a surface; default two voxels")
        ->type_name("METRES")
        ->check(CLI::PositiveNumber);
    app.add_option("--range-max", options.range_max_m, "Points farther away are left out")
        ->type_name("METRES")
        ->capture_default_str();
  }
};

int Main(int argc, char** argv) {
  CLI::App app{
      "A fleet of UAVs rebuilds an unknown place in 3D, to the fidelity asked for, in the least flight.",
      "citrine"};
  app.require_subcommand(1);
  app.footer(
      "build, test [LABEL]: of the script ./citrine. Example: ./citrine run house --uavs 3 --pace max");
  int exit_code = kCompleted;
  std::string world, results;

  CLI::App* run = app.add_subcommand("run", "Fly a mission");
  RunCommand run_command(*run);
  run->final_callback([&] { exit_code = RunMission(run_command.Parsed()); });
  app.add_subcommand("doctor", "What commonly breaks, and the command that mends it")->final_callback([&] {
    exit_code = Doctor();
  });
  app.add_subcommand("config", "Every key: unit, default, range, meaning and source")->final_callback([&] {
    exit_code = ShowKeys();
  });
  CLI::App* world_command = app.add_subcommand("world", "What a world file holds, and what is wrong with it");
  world_command->add_option("file", world)->required()->type_name("FILE");
  world_command->final_callback([&] { exit_code = ShowWorld(world); });
  CLI::App* replay = app.add_subcommand("replay", "Play a recorded mission on the bus, or into one module");
  ReplayCommand replay_command(*replay);
  replay->final_callback([&] { exit_code = ReplayLog(replay_command.options); });
  std::string exported, to, export_out;
  CLI::App* export_command = app.add_subcommand("export", "Write a recorded mission for other programs");
  export_command->add_option("recording", exported, "A log or result folder")
      ->required()
      ->type_name("RUN|LOG");
  export_command->add_option("--to", to, "mcap: for Foxglove, Rerun and PlotJuggler")
      ->required()
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"mcap"}));
  export_command->add_option("--out", export_out, "The file to write; default: beside the log")
      ->type_name("FILE");
  export_command->final_callback([&] { exit_code = ExportLog(exported, to, export_out); });
  CLI::App* explain =
      app.add_subcommand("explain", "One recorded decision: candidates, scores, who won and why");
  ExplainCommand explain_command(*explain);
  explain->final_callback([&] { exit_code = ExplainDecision(explain_command.options); });
  CLI::App* report = app.add_subcommand("report", "Write the results of a recorded mission anew");
  report->add_option("recording", results, "A log or result folder")->required()->type_name("RUN|LOG");
  report->final_callback([&] { exit_code = Report(results); });
  AddWatchCommands(app, exit_code);

  CLI::App* sweep = app.add_subcommand("sweep", "Fly many missions and write tables and figures");
  SweepCommand sweep_command(*sweep);
  sweep->final_callback([&] { exit_code = RunSweep(sweep_command.options); });

  CLI::App* fuse = app.add_subcommand("fuse", "Recorded LiDAR scans and poses into a map and a mesh");
  FuseCommand fuse_command(*fuse);
  fuse->final_callback([&] { exit_code = Fuse(fuse_command.options); });

  CLI::App* compare = app.add_subcommand("compare", "What differs between two runs, or two sweeps");
  std::string compare_a, compare_b;
  compare->add_option("a", compare_a, "Result folder of a run, of a sweep, or of a part of one")
      ->required()
      ->type_name("A");
  compare->add_option("b", compare_b, "The same of the other")->required()->type_name("B");
  compare->final_callback([&] { exit_code = CompareResults(compare_a, compare_b); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kCompleted : kWrongUse;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "citrine: %s\n", error.what());
    return kSetUpProblem;
  }
  return exit_code;
}

}  // namespace
}  // namespace citrine

int main(int argc, char** argv) { return citrine::Main(argc, argv); }
