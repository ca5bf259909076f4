#pragma once

namespace CLI {
class App;
}

namespace citrine {

/// Adds the commands with which one watches a mission or looks into a recording: spy, top, echo and log.
/// @param exit_code where they leave it
void AddWatchCommands(CLI::App& app, int& exit_code);

}  // namespace citrine
