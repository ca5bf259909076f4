#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace citrine {

struct CommandResult {
  int exit_code = -1;
  std::string output;  ///< what it said on both streams
};

/// Runs a line of shell.
inline CommandResult RunCommandLine(const std::string& line) {
  CommandResult result;
  std::FILE* pipe = popen(("( " + line + " ) 2>&1").c_str(), "r");
  std::array<char, 512> bytes;
  while (const std::size_t n = std::fread(bytes.data(), 1, bytes.size(), pipe))
    result.output.append(bytes.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

/// Runs the program behind ./citrine.
inline CommandResult RunCitrine(const std::string& arguments) {
  return RunCommandLine(std::string(CITRINE_BIN_DIR) + "/launch " + arguments);
}

}  // namespace citrine
