#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "modules/every_channel.h"
#include "tests/architecture/source_tree.h"

namespace citrine {
namespace {

using Table = std::map<std::string, std::string>;  ///< type by channel

Table FromHeader() {
  const std::regex row(R"re(.* (Uav)?Channel<citrine_lcm::(\w+)> k\w+\{"(\w+)"\};)re");
  Table table;
  const SourceFile file = FilesUnder("modules", {"modules/channels.h"}).at(0);
  for (const std::string& line : file.lines)
    if (std::smatch m; std::regex_match(line, m, row))
      table[(m[1].matched ? "UAV<i>_" : "") + m[3].str()] = m[2];
  return table;
}

Table FromReadme() {
  const std::regex row(R"(\| `([A-Z_<>i]+)` \| `(\w+)` \|.*)");
  Table table;
  const SourceFile file = FilesUnder("lcmtypes", {"README.md"}).at(0);
  for (const std::string& line : file.lines)
    if (std::smatch m; std::regex_match(line, m, row)) table[m[1]] = m[2];
  return table;
}

TEST(ChannelTable, SaysInTheReadmeWhatTheCodeSays) {
  const Table header = FromHeader();
  EXPECT_EQ(header.size(), 17u);
  EXPECT_EQ(header, FromReadme());
}

TEST(ChannelTable, IsVisitedWhole) {
  std::set<std::string> visited;
  ForEveryChannel([&]<template <class> class On, class Message>(const On<Message>& channel) {
    if constexpr (requires { channel.noun; })
      visited.insert(std::string("UAV<i>_") + channel.noun);
    else
      visited.insert(channel.name);
  });
  std::set<std::string> in_header;
  for (const auto& [channel, type] : FromHeader()) in_header.insert(channel);
  EXPECT_EQ(visited, in_header);
}

TEST(ChannelTable, NamesEveryTypeThatThereIs) {
  std::map<std::string, std::string> by_type;
  for (const auto& [channel, type] : FromHeader()) by_type[type] = channel;
  for (const SourceFile& file : FilesUnder("lcmtypes", {".lcm"})) {
    const std::string type = file.path.substr(9, file.path.size() - 13);
    EXPECT_TRUE(type.starts_with("archive/") || by_type.contains(type))
        << file.path << " travels on no channel";
  }
}

const std::regex kField(R"(^    (int\w+|double|float|byte|boolean|string)\s+(\w+)(\[\w+\])?;.*)");

TEST(ChannelTable, HasTypesThatBeginWithTimeAndCountAndHaveABlobLast) {
  for (const SourceFile& file : FilesUnder("lcmtypes", {".lcm"})) {
    std::vector<std::string> types, names;
    for (const std::string& line : file.lines)
      if (std::smatch m; std::regex_match(line, m, kField)) {
        types.push_back(m[1]);
        names.push_back(m[2]);
      }
    ASSERT_GE(names.size(), 3u) << file.path;
    EXPECT_EQ(names[0], "utime") << file.path;
    EXPECT_EQ(names[1], "seq") << file.path;
    for (std::size_t i = 0; i + 1 < types.size(); ++i)
      EXPECT_NE(types[i], "byte") << file.path << ": a blob comes last";
  }
}

// lcm-gen takes a name as it is: one that Python, Java or JavaScript reserves cannot be read there.
TEST(ChannelTable, HasFieldsWhoseNamesAreFreeInEveryLanguageOfLcm) {
  const std::set<std::string> reserved = {
      "and",    "as",      "assert", "async",  "await", "class", "def",      "default", "del",
      "delete", "except",  "exec",   "final",  "for",   "from",  "function", "global",  "if",
      "import", "in",      "is",     "lambda", "len",   "let",   "native",   "new",     "not",
      "or",     "package", "pass",   "print",  "raise", "self",  "super",    "this",    "try",
      "typeof", "var",     "while",  "with",   "yield"};
  for (const SourceFile& file : FilesUnder("lcmtypes", {".lcm"}))
    for (const std::string& line : file.lines)
      if (std::smatch m; std::regex_match(line, m, kField)) {
        EXPECT_FALSE(reserved.contains(m[2])) << file.path << ": " << m[2];
      }
}

}  // namespace
}  // namespace citrine
