#include "core/config/sweep_plan.h"

#include <charconv>

#include "core/config/nearest_name.h"
#include "core/config/toml_section.h"

namespace citrine {
namespace {

constexpr int kMostSeeds = 1000;

template <class Section>
Section ReadWhole(const toml::table& table, const std::string& path) {
  Section section;
  FieldNames fields;
  section.Visit(fields);
  for (const auto& [key, value] : table)
    if (const std::string name(key.str()); !Contains(fields.all, name))
      throw ConfigError(path + "." + name + ": unknown key; did you mean " + path + "." +
                        NearestName(name, fields.all) + "?");
  ReadSection(table, path, section);
  return section;
}

template <class Row>
std::vector<Row> ReadRows(const toml::table& file, const std::string& name) {
  const toml::node* node = file.get(name);
  if (!node) throw ConfigError(name + ": missing; a sweep has at least one [[" + name + "]]");
  if (!node->is_array_of_tables()) Refuse(name, "rows of [[" + name + "]]", *node);
  std::vector<Row> rows;
  for (const toml::node& row : *node->as_array())
    rows.push_back(ReadWhole<Row>(*row.as_table(), name + "[" + std::to_string(rows.size()) + "]"));
  return rows;
}

/// A name is a folder's: letters, digits and -_.+ only, and not hidden.
void CheckName(const std::string& path, const std::string& name) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.+";
  if (name.empty() || name.front() == '.' || name.find_first_not_of(kLetters) != std::string::npos)
    throw ConfigError(path + ": must be a name of letters, digits and -_.+, is '" + name + "'");
}

template <class Row>
void FinishRows(const std::string& kind, std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string path = kind + "[" + std::to_string(i) + "].name";
    CheckName(path, rows[i].name);
    if (Contains(names, rows[i].name)) throw ConfigError(path + ": there are two of '" + rows[i].name + "'");
    names.push_back(rows[i].name);
    if (rows[i].title.empty()) rows[i].title = rows[i].name;
  }
}

void Finish(SweepPlan& plan) {
  SweepSection& sweep = plan.sweep;
  CheckName("sweep.name", sweep.name);
  if (sweep.title.empty()) sweep.title = sweep.name;
  if (sweep.seeds.empty()) throw ConfigError("sweep.seeds: must be a list of integers, is []");
  for (std::size_t i = 0; i < plan.worlds.size(); ++i) {
    SweepWorld& world = plan.worlds[i];
    if (world.mission.empty()) throw ConfigError("world[" + std::to_string(i) + "].mission: missing");
    if (world.name.empty()) world.name = world.mission;
  }
  FinishRows("world", plan.worlds);
  FinishRows("variant", plan.variants);
  std::vector<std::string> names;
  for (const SweepVariant& variant : plan.variants) names.push_back(variant.name);
  if (sweep.baseline.empty()) sweep.baseline = names.front();
  if (!Contains(names, sweep.baseline))
    throw ConfigError("sweep.baseline: no variant '" + sweep.baseline + "'; did you mean " +
                      NearestName(sweep.baseline, names) + "?");
}

int SeedOf(std::string_view text, const std::string& all) {
  int seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size() || seed < 0)
    throw ConfigError("seeds: must be like 1-10 or 1,2,5, is '" + all + "'");
  return seed;
}

}  // namespace

SweepPlan ParseSweep(const std::string& toml_text) {
  const toml::table file = ParseToml(toml_text);
  for (const auto& [key, node] : file)
    if (key != "sweep" && key != "world" && key != "variant")
      throw ConfigError(std::string(key.str()) + ": unknown; a sweep has [sweep], [[world]] and [[variant]]");
  const toml::node* sweep = file.get("sweep");
  if (!sweep) throw ConfigError("sweep: missing; a sweep begins with [sweep]");
  if (!sweep->is_table()) Refuse("sweep", "a section, [sweep]", *sweep);
  SweepPlan plan;
  plan.sweep = ReadWhole<SweepSection>(*sweep->as_table(), "sweep");
  plan.worlds = ReadRows<SweepWorld>(file, "world");
  plan.variants = ReadRows<SweepVariant>(file, "variant");
  Finish(plan);
  return plan;
}

std::vector<int> ParseSeeds(const std::string& text) {
  std::vector<int> seeds;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t dash = part.find('-');
    const int first = SeedOf(std::string_view(part).substr(0, dash), text);
    const int last =
        dash == std::string::npos ? first : SeedOf(std::string_view(part).substr(dash + 1), text);
    if (last < first || last - first >= kMostSeeds) SeedOf("", text);
    for (int seed = first; seed <= last; ++seed) seeds.push_back(seed);
  }
  if (seeds.empty()) SeedOf("", text);
  return seeds;
}

}  // namespace citrine
