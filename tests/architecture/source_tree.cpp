#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace citrine {

std::vector<SourceFile> FilesUnder(const std::string& folder, const std::vector<std::string>& endings) {
  const std::filesystem::path root(CITRINE_SOURCE_DIR);
  std::vector<SourceFile> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    const std::string path = entry.path().lexically_relative(root);
    if (!entry.is_regular_file() ||
        std::ranges::none_of(endings, [&](const std::string& ending) { return path.ends_with(ending); }))
      continue;
    SourceFile file{path, {}};
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) file.lines.push_back(line);
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace citrine
