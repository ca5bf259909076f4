#include "core/config/config_file.h"

#include "core/config/check_limits.h"
#include "core/config/nearest_name.h"
#include "core/config/toml_section.h"

namespace citrine {
namespace {

struct SectionNames {
  std::vector<std::pair<std::string, FieldNames>> sections;

  template <class Section>
  void operator()(const char* name, Section& section) {
    section.Visit(sections.emplace_back(name, FieldNames{}).second);
  }
};

const SectionNames& Known() {
  static const SectionNames names = [] {
    SectionNames n;
    MissionConfig config;
    config.Visit(n);
    return n;
  }();
  return names;
}

const FieldNames& KnownSection(const std::string& section) {
  std::vector<std::string> names;
  for (const auto& [name, fields] : Known().sections) {
    if (name == section) return fields;
    names.push_back(name);
  }
  throw ConfigError(section + ": unknown section; did you mean " + NearestName(section, names) + "?");
}

[[noreturn]] void RefuseUnknownKey(const std::string& section, const std::string& key,
                                   const FieldNames& fields) {
  std::string nearest = section + "." + NearestName(key, fields.all);
  for (const auto& [other, names] : Known().sections)
    if (Contains(names.all, key)) nearest = other + "." + key;
  throw ConfigError(section + "." + key + ": unknown key; did you mean " + nearest + "?");
}

struct SectionReader {
  const toml::table& mission;

  template <class Section>
  void operator()(const char* name, Section& section) {
    if (const toml::node* node = mission.get(name)) ReadSection(*node->as_table(), name, section);
  }
};

void RefuseUnknown(const toml::table& mission) {
  for (const auto& [section_key, node] : mission) {
    const std::string section(section_key.str());
    const FieldNames& fields = KnownSection(section);
    if (!node.is_table()) Refuse(section, "a section, [" + section + "]", node);
    for (const auto& [key, value] : *node.as_table())
      if (!Contains(fields.all, std::string(key.str())) && !(section == "quality" && key.str() == "region"))
        RefuseUnknownKey(section, std::string(key.str()), fields);
  }
}

std::vector<QualityRegionSection> ReadRegions(const toml::table& mission) {
  const auto node = mission["quality"]["region"];
  if (!node) return {};
  if (!node.is_array_of_tables()) Refuse("quality.region", "rows of [[quality.region]]", *node.node());
  FieldNames fields;
  QualityRegionSection().Visit(fields);
  std::vector<QualityRegionSection> regions;
  for (const toml::node& row : *node.as_array()) {
    const std::string path = "quality.region[" + std::to_string(regions.size()) + "]";
    const toml::table& table = *row.as_table();
    for (const auto& [key, value] : table)
      if (!Contains(fields.all, std::string(key.str())))
        RefuseUnknownKey(path, std::string(key.str()), fields);
    for (const std::string& name : fields.all)
      if (!table.contains(name)) throw ConfigError(path + "." + name + ": missing");
    ReadSection(table, path, regions.emplace_back());
  }
  return regions;
}

/// A text may stand without quotes: planner.strategy=racer.
toml::table ParseValue(const std::string& path, const std::string& text, bool is_text) {
  try {
    toml::table parsed = toml::parse("value = " + text);
    if (parsed.size() == 1 && (!is_text || parsed["value"].is_string())) return parsed;
  } catch (const toml::parse_error&) {
  }
  if (!is_text) throw ConfigError(path + ": cannot read the value '" + text + "'");
  return toml::table{{"value", text}};
}

void Apply(const std::string& override_text, toml::table& mission) {
  const std::size_t equals = override_text.find('='), dot = override_text.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw ConfigError("'" + override_text + "': must be section.key=value");
  const std::string section = override_text.substr(0, dot),
                    key = override_text.substr(dot + 1, equals - dot - 1);
  const FieldNames& fields = KnownSection(section);
  if (!Contains(fields.all, key)) RefuseUnknownKey(section, key, fields);
  toml::node& table = mission.insert(section, toml::table{}).first->second;
  if (!table.is_table()) Refuse(section, "a section, [" + section + "]", table);
  const toml::table parsed =
      ParseValue(section + "." + key, override_text.substr(equals + 1), Contains(fields.texts, key));
  table.as_table()->insert_or_assign(key, *parsed.get("value"));
}

}  // namespace

MissionConfig ParseMission(const std::string& toml_text, const std::vector<std::string>& overrides) {
  toml::table mission = ParseToml(toml_text);
  for (const std::string& override_text : overrides) Apply(override_text, mission);
  RefuseUnknown(mission);
  MissionConfig config;
  SectionReader sections{mission};
  config.Visit(sections);
  config.quality_regions = ReadRegions(mission);
  CheckLimits(config);
  return config;
}

}  // namespace citrine
