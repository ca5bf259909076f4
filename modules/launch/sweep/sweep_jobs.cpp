#include "modules/launch/sweep/sweep_jobs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/config/config_file.h"
#include "core/config/nearest_name.h"
#include "logs/metric_number.h"
#include "modules/launch/mission_file.h"
#include "modules/launch/project.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSweeps = "missions/sweeps";

fs::path FindSweepFile(const std::string& sweep) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(ProjectFolder() / kSweeps, none))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  for (const fs::path& path :
       {fs::path(sweep), ProjectFolder() / sweep, fs::path(kSweeps) / (sweep + ".toml"),
        ProjectFolder() / kSweeps / (sweep + ".toml")})
    if (fs::is_regular_file(path)) return fs::canonical(path);
  const std::string nearest = NearestName(sweep, names);
  throw ConfigError(sweep + ": neither a sweep file nor a name in " + kSweeps + "/" +
                    (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

SweepPlan ReadPlan(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw ConfigError(file.string() + ": cannot be read");
  try {
    return ParseSweep(text.str());
  } catch (const ConfigError& error) {
    throw ConfigError(file.string() + ": " + error.what());
  }
}

/// Relative to the project if it is in it: such a path holds on every host.
std::string FromProject(const fs::path& path) {
  const fs::path relative = fs::absolute(path).lexically_normal().lexically_relative(ProjectFolder());
  return relative.empty() || *relative.begin() == ".." ? fs::absolute(path).lexically_normal() : relative;
}

void CheckColumns(const SweepPlan& plan) {
  const std::vector<std::string> keys = logs::NumberKeys();
  for (const std::string& column : plan.sweep.columns)
    if (std::find(keys.begin(), keys.end(), column) == keys.end())
      throw ConfigError("sweep.columns: no number '" + column + "' in metrics.json; did you mean " +
                        NearestName(column, keys) + "?");
}

/// Whether a world is there; one that need not be is left out.
bool IsThere(const SweepWorld& world, const std::string& mission_path, Sweep& sweep) {
  if (world.world.empty()) return true;
  try {
    FindWorldFile(world.world, mission_path);
    return true;
  } catch (const ConfigError&) {
    if (!world.optional) throw;
  }
  sweep.left_out.push_back(world.title + " is left out: there is no " + world.world + ".");
  return false;
}

std::string CommandOf(const SweepWorld& world, const std::vector<std::string>& set, int seed,
                      const std::string& mission) {
  std::string command = "run " + ShellWord(mission) + " --in-process --seed " + std::to_string(seed);
  if (!world.world.empty()) command += " --world " + ShellWord(world.world);
  for (const std::string& override_text : set) command += " --set " + ShellWord(override_text);
  return command;
}

void Append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void ListJobs(const SweepOptions& options, Sweep& sweep) {
  std::erase_if(sweep.plan.worlds, [&](const SweepWorld& world) {
    return !IsThere(world, ReadMissionFile(world.mission).path, sweep);
  });
  for (const int seed : sweep.plan.sweep.seeds)
    for (const SweepWorld& world : sweep.plan.worlds)
      for (const SweepVariant& variant : sweep.plan.variants) {
        const std::string cell = world.name + "/" + variant.name;
        if (cell.find(options.only) == std::string::npos) continue;
        std::vector<std::string> set = sweep.plan.sweep.set;
        Append(set, world.set);
        Append(set, variant.set);
        Append(set, options.set);
        const MissionFile file = ReadMissionFile(world.mission);
        try {
          ParseMission(file.toml, set);
        } catch (const ConfigError& error) {
          throw ConfigError(cell + ": " + error.what());
        }
        const std::string mission = fs::exists(world.mission) ? FromProject(file.path) : world.mission;
        sweep.jobs.push_back(
            {world.name, variant.name, seed,
             FromProject(fs::path(sweep.folder) / world.name / variant.name / std::to_string(seed)),
             CommandOf(world, set, seed, mission)});
      }
  if (sweep.jobs.empty())
    throw ConfigError("nothing to fly: no world and variant match --only " + options.only);
}

std::string CommandThatMakes(const fs::path& file, const SweepOptions& options) {
  std::string command = "./citrine sweep " + ShellWord(FromProject(file));
  if (!options.seeds.empty()) command += " --seeds " + options.seeds;
  if (!options.only.empty()) command += " --only " + ShellWord(options.only);
  for (const std::string& override_text : options.set) command += " --set " + ShellWord(override_text);
  return command;
}

}  // namespace

Sweep PlanSweep(const SweepOptions& options) {
  const fs::path file = FindSweepFile(options.sweep);
  Sweep sweep;
  sweep.plan = ReadPlan(file);
  CheckColumns(sweep.plan);
  if (!options.seeds.empty()) sweep.plan.sweep.seeds = ParseSeeds(options.seeds);
  const fs::path out =
      options.out.empty() ? fs::path("results/sweeps") / sweep.plan.sweep.name : fs::path(options.out);
  sweep.folder = fs::absolute(out).lexically_normal();
  sweep.command = CommandThatMakes(file, options);
  ListJobs(options, sweep);
  return sweep;
}

std::string ShellWord(const std::string& text) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./+=:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string ShellLine(const SweepJob& job, const std::string& program, bool keep_logs) {
  const std::string folder = ShellWord(job.folder);
  std::string line = "mkdir -p " + folder + " && " + ShellWord(program) + " " + job.command + " --out " +
                     folder + " >" + folder + "/run.log 2>&1; e=$?;";
  if (!keep_logs)
    for (const char* file : {"mission.lcmlog", "mesh.ply", "map.bt"})
      line += " rm -f " + folder + "/" + file + ";";
  return line + " exit $e";
}

}  // namespace citrine
