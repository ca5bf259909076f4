#include "modules/runtime/log_parts.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLeastDigits = 3;

bool IsNumber(const std::string& text) {
  return text.size() >= kLeastDigits &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

}  // namespace

std::string LogPart(const std::string& name, int part) {
  const std::string number = std::to_string(part);
  return name + "." + std::string(kLeastDigits - std::min(kLeastDigits, number.size()), '0') + number;
}

std::vector<std::string> LogFiles(const std::string& name) {
  if (fs::is_regular_file(name)) return {name};
  std::vector<std::string> parts;
  const fs::path path(name), folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string begins = path.filename().string() + ".";
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string file = entry.path().filename();
    if (file.starts_with(begins) && IsNumber(file.substr(begins.size())))
      parts.push_back(name + file.substr(begins.size() - 1));
  }
  std::sort(parts.begin(), parts.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return parts;
}

}  // namespace citrine
