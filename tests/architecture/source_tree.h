#pragma once

#include <string>
#include <vector>

namespace citrine {

/// A text file of the project.
struct SourceFile {
  std::string path;  ///< from the project root
  std::vector<std::string> lines;
};

/// Files under a folder of the project whose names end in one of `endings`.
std::vector<SourceFile> FilesUnder(const std::string& folder, const std::vector<std::string>& endings);

/// The folders of code, in order of layer.
inline const std::vector<std::string> kLayers = {"core", "sim",  "fusion", "planner",
                                                 "viz",  "logs", "modules"};

}  // namespace citrine
