#include "modules/launch/project.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>

namespace citrine {
namespace {

std::string OutputOf(const std::string& command) {
  std::string output;
  if (std::FILE* pipe = popen(command.c_str(), "r")) {
    std::array<char, 256> bytes;
    while (const std::size_t n = std::fread(bytes.data(), 1, bytes.size(), pipe))
      output.append(bytes.data(), n);
    pclose(pipe);
  }
  return output;
}

}  // namespace

const std::filesystem::path& ProjectFolder() {
  static const std::filesystem::path folder = CITRINE_PROJECT_DIR;
  return folder;
}

SourceVersion ReadSourceVersion() {
  constexpr const char* kDirty = "-dirty";
  std::string text = OutputOf("git -C '" + ProjectFolder().string() +
                              "' describe --always --dirty --abbrev=40 --exclude '*' 2>/dev/null");
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
  const std::size_t dirty = text.find(kDirty);
  return {text.substr(0, dirty), dirty != std::string::npos};
}

std::string MissingPackages() {
  std::ifstream in(ProjectFolder() / "packages.txt");
  std::vector<std::string> packages;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') packages.push_back(line);
  return MissingPackages(packages);
}

std::string MissingPackages(const std::vector<std::string>& packages) {
  std::string missing;
  for (const std::string& package : packages) {
    const std::string status =
        OutputOf("dpkg-query -W -f '${db:Status-Status}' '" + package + "' 2>/dev/null");
    if (status != "installed") missing += (missing.empty() ? "" : " ") + package;
  }
  return missing;
}

}  // namespace citrine
