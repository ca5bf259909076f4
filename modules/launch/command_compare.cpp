#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/config/config.h"
#include "core/config/flat_toml.h"
#include "logs/comparison.h"
#include "modules/launch/commands.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetrics = "metrics.json";

std::string ReadText(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw ConfigError(path.string() + ": cannot be read");
  return text.str();
}

logs::ComparedRun ReadRun(const fs::path& folder, const std::string& cell) {
  try {
    return {cell, logs::MetricsFromJson(ReadText(folder / kMetrics)),
            FlattenToml(ReadText(folder / "mission.toml"))};
  } catch (const std::runtime_error& error) {
    throw ConfigError(folder.string() + ": " + error.what());
  }
}

/// The run that a folder is, or all runs in it, in order of name; a run's cell is the path to the folder that
/// it lies in.
std::vector<logs::ComparedRun> ReadRuns(const fs::path& folder) {
  if (fs::exists(folder / kMetrics)) return {ReadRun(folder, "")};
  if (!fs::is_directory(folder)) throw ConfigError(folder.string() + ": no such result folder");
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == kMetrics) found.push_back(entry.path().parent_path());
  if (found.empty()) throw ConfigError(folder.string() + ": holds no " + kMetrics);
  std::sort(found.begin(), found.end());
  std::vector<logs::ComparedRun> runs;
  for (const fs::path& run : found) {
    const std::string cell = run.parent_path().lexically_relative(folder);
    runs.push_back(ReadRun(run, cell == "." ? "" : cell));
  }
  return runs;
}

}  // namespace

int CompareResults(const std::string& a, const std::string& b) {
  const fs::path folder_a = fs::absolute(a).lexically_normal(), folder_b = fs::absolute(b).lexically_normal();
  std::printf("A: %s\nB: %s\n\n%s", a.c_str(), b.c_str(),
              logs::Compare(ReadRuns(folder_a), ReadRuns(folder_b)).c_str());
  return kCompleted;
}

}  // namespace citrine
