#include "fusion/cloud_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "fusion/record_reader.h"

namespace citrine::fusion {
namespace {

namespace fs = std::filesystem;

std::string EndingOf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// Sets the field that `name` stands for, if it is one of x, y and z.
void SetField(RecordReader::Layout& layout, const std::string& name, int offset, int bytes) {
  if (name == "x") layout.x = {offset, bytes};
  if (name == "y") layout.y = {offset, bytes};
  if (name == "z") layout.z = {offset, bytes};
}
bool Complete(const RecordReader::Layout& layout) {
  return layout.x.offset >= 0 && layout.y.offset >= 0 && layout.z.offset >= 0;
}

std::vector<Eigen::Vector3f> ReadKitti(const std::string& file) {
  constexpr std::size_t kRecord = 16;
  RecordReader reader(file);
  const std::size_t bytes = reader.bytes_left();
  if (bytes % kRecord != 0)
    throw std::runtime_error(file + ": " + std::to_string(bytes) +
                             " bytes are not a whole number of points of 16, cut at byte " +
                             std::to_string(bytes / kRecord * kRecord));
  return reader.Records(bytes / kRecord, {{0, 4}, {4, 4}, {8, 4}, kRecord}, false);
}

std::vector<Eigen::Vector3f> ReadPlyCloud(const std::string& file) {
  static const std::map<std::string, int> kBytes{{"char", 1},  {"int8", 1},    {"uchar", 1},  {"uint8", 1},
                                                 {"short", 2}, {"int16", 2},   {"ushort", 2}, {"uint16", 2},
                                                 {"int", 4},   {"int32", 4},   {"uint", 4},   {"uint32", 4},
                                                 {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  RecordReader reader(file);
  std::string line;
  if (!reader.NextLine(line) || line != "ply") reader.RefuseLine("\"ply\" is expected");
  RecordReader::Layout layout;
  std::optional<std::size_t> count;
  bool text = false, in_vertex = false, any_format = false;
  for (;;) {
    if (!reader.NextLine(line)) reader.RefuseLine("the header does not end");
    std::istringstream words(line);
    std::string word, type, name;
    words >> word;
    if (word == "end_header") break;
    if (word == "format") {
      words >> type;
      text = type == "ascii";
      any_format = true;
      if (!text && type != "binary_little_endian")
        reader.RefuseLine("format " + type + ": ascii or binary_little_endian is read");
    } else if (word == "element") {
      long long number = -1;
      if (!(words >> name >> number) || number < 0)
        reader.RefuseLine("\"element <name> <count>\" is expected");
      if (!count && name != "vertex" && number > 0) reader.RefuseLine("element vertex is expected first");
      in_vertex = name == "vertex";
      if (in_vertex) count = static_cast<std::size_t>(number);
    } else if (word == "property" && in_vertex) {
      words >> type >> name;
      const auto bytes = kBytes.find(type);
      if (bytes == kBytes.end()) reader.RefuseLine("property of type " + type + " in a vertex");
      if ((name == "x" || name == "y" || name == "z") && type[0] != 'f' && type[0] != 'd')
        reader.RefuseLine(name + " is to be a float or a double");
      SetField(layout, name, layout.stride, bytes->second);
      layout.stride += text ? 1 : bytes->second;
    }
  }
  if (!any_format || !count || !Complete(layout))
    reader.RefuseLine("the header names no format, or no vertex with x, y and z");
  return reader.Records(*count, layout, text);
}

std::vector<Eigen::Vector3f> ReadPcd(const std::string& file) {
  RecordReader reader(file);
  std::map<std::string, std::vector<std::string>> header;
  std::string line, keyword;
  while (keyword != "DATA") {
    if (!reader.NextLine(line)) reader.RefuseLine("the header does not end: DATA is expected");
    std::istringstream words(line);
    if (!(words >> keyword) || keyword[0] == '#') continue;
    for (std::string word; words >> word;) header[keyword].push_back(word);
  }
  const auto& fields = header["FIELDS"];
  const auto one = [&](const std::string& key) {
    return header[key].size() == 1 ? header[key][0] : std::string();
  };
  const bool text = one("DATA") == "ascii";
  if (!text && one("DATA") != "binary")
    reader.RefuseLine("DATA " + one("DATA") + ": ascii or binary is read");
  const auto whole = [&](const std::string& word, const char* what) {
    char* end = nullptr;
    const long long number = std::strtoll(word.c_str(), &end, 10);
    if (word.empty() || *end != '\0' || number < 0)
      reader.RefuseLine(std::string(what) + " \"" + word + "\" is no count");
    return number;
  };
  if (header["SIZE"].size() != fields.size() || header["TYPE"].size() != fields.size())
    reader.RefuseLine("FIELDS, SIZE and TYPE are not equally many");
  RecordReader::Layout layout;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const int bytes = static_cast<int>(whole(header["SIZE"][i], "SIZE"));
    const int count = i < header["COUNT"].size() ? static_cast<int>(whole(header["COUNT"][i], "COUNT")) : 1;
    if (bytes > 8 || count > 65536)
      reader.RefuseLine("a field of " + std::to_string(count) + " x " + std::to_string(bytes) + " bytes");
    if ((fields[i] == "x" || fields[i] == "y" || fields[i] == "z") &&
        (header["TYPE"][i] != "F" || (bytes != 4 && bytes != 8) || count != 1))
      reader.RefuseLine(fields[i] + " is to be one float or double");
    SetField(layout, fields[i], layout.stride, bytes);
    layout.stride += text ? count : bytes * count;
  }
  if (!Complete(layout)) reader.RefuseLine("FIELDS without x, y and z");
  return reader.Records(static_cast<std::size_t>(whole(one("POINTS"), "POINTS")), layout, text);
}

}  // namespace

std::vector<std::string> FindCloudFiles(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder + ": is no folder");
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string ending = EndingOf(entry.path());
    if (entry.is_regular_file() && (ending == ".bin" || ending == ".ply" || ending == ".pcd"))
      files.push_back(entry.path().string());
  }
  if (files.empty()) throw std::runtime_error(folder + ": holds no .bin, .ply or .pcd file");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Eigen::Vector3f> ReadCloud(const std::string& file) {
  const std::string ending = EndingOf(file);
  return ending == ".ply" ? ReadPlyCloud(file) : ending == ".pcd" ? ReadPcd(file) : ReadKitti(file);
}

}  // namespace citrine::fusion
