#include <iomanip>
#include <sstream>

#include "core/config/config_file.h"
#include "core/config/value_kind.h"

namespace citrine {
namespace {

std::string Quoted(const std::string& text) {
  std::ostringstream out;
  out << '"';
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out << '\\' << c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out << "\\u" << std::hex << std::setw(4) << std::setfill('0') << static_cast<int>(c) << std::dec;
    else
      out << c;
  }
  out << '"';
  return out.str();
}

std::string TomlValue(bool value) { return value ? "true" : "false"; }
std::string TomlValue(int value) { return std::to_string(value); }
std::string TomlValue(double value) {
  const std::string text = NumberText(value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}
std::string TomlValue(const std::string& value) { return Quoted(value); }
std::string TomlValue(const Eigen::Vector3d& value) { return VectorText(value); }
std::string TomlValue(const std::vector<Eigen::Vector3d>& values) {
  std::string text;
  for (const Eigen::Vector3d& value : values) text += (text.empty() ? "" : ", ") + VectorText(value);
  return "[" + text + "]";
}

struct FieldWriter {
  std::ostream& out;

  template <class T>
  void operator()(const char* name, const T& value, const Key&) {
    out << name << " = " << TomlValue(value) << "\n";
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value, const Key& key) {
    if (value) (*this)(name, *value, key);
  }
};

struct SectionWriter {
  std::ostream& out;

  template <class Section>
  void operator()(const char* name, Section& section) {
    out << "[" << name << "]\n";
    FieldWriter writer{out};
    section.Visit(writer);
    out << "\n";
  }
};

struct FieldDescriber {
  std::ostream& out;
  std::string section;

  template <class T>
  void operator()(const char* name, const T& value, const Key& key) {
    Row(name, key, Range(value, key), TomlValue(value));
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value, const Key& key) {
    Row(name, key, Range(T{}, key), value ? TomlValue(*value) : "(none)");
  }

 private:
  static std::string Range(bool, const Key&) { return "true | false"; }
  static std::string Range(const std::string&, const Key& key) { return OptionsText(key); }
  template <class T>
  static std::string Range(const T&, const Key& key) {
    return RangeText(key);
  }

  void Row(const char* name, const Key& key, const std::string& range, const std::string& standard) {
    out << std::left << std::setw(30) << section + "." + name << " " << std::setw(6) << key.unit << " "
        << std::setw(18) << standard << " " << std::setw(14) << range << "  " << key.doc << "\n";
  }
};

struct SectionDescriber {
  std::ostream& out;

  template <class Section>
  void operator()(const char* name, Section& section) {
    FieldDescriber describer{out, name};
    section.Visit(describer);
    out << "\n";
  }
};

}  // namespace

std::string ToToml(const MissionConfig& config) {
  std::ostringstream out;
  MissionConfig copy = config;
  SectionWriter sections{out};
  copy.Visit(sections);
  for (QualityRegionSection& region : copy.quality_regions) {
    out << "[[quality.region]]\n";
    FieldWriter writer{out};
    region.Visit(writer);
    out << "\n";
  }
  return out.str();
}

std::string DescribeKeys() {
  std::ostringstream out;
  out << std::left << std::setw(30) << "key"
      << " " << std::setw(6) << "unit"
      << " " << std::setw(18) << "default"
      << " " << std::setw(14) << "allowed"
      << "  meaning\n\n";
  MissionConfig config;
  SectionDescriber sections{out};
  config.Visit(sections);
  QualityRegionSection region;
  FieldDescriber describer{out, "[[quality.region]]"};
  region.Visit(describer);
  return out.str();
}

}  // namespace citrine
