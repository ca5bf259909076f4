#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

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

/// Whether somebody here may have a network, and file systems, of his own.
inline bool PrivateNetworksAllowed() { return RunCommandLine("unshare -rnm true").exit_code == 0; }

/// Runs the program behind ./citrine.
inline CommandResult RunCitrine(const std::string& arguments) {
  return RunCommandLine(std::string(CITRINE_BIN_DIR) + "/launch " + arguments);
}

/// Every one of these ends with that code.
inline void ExpectExitCode(int code, const std::vector<std::string>& arguments) {
  for (const std::string& each : arguments) {
    const CommandResult result = RunCitrine(each);
    EXPECT_EQ(result.exit_code, code) << "citrine " << each << ": " << result.output;
  }
}

}  // namespace citrine
