#pragma once

#include <string>
#include <vector>

namespace citrine::logs {

/// A table of texts: the first cell of a row is its name. Numbers are written "231.2 ± 4.5"; what is in
/// `emphasised` rows is printed bold, what is in `quoted` ones (of others' work) in italics.
struct TextTable {
  struct Row {
    std::vector<std::string> cells;  ///< as many as the head's
    enum class Style { kPlain, kEmphasised, kQuoted } style = Style::kPlain;
  };
  std::string caption;
  std::vector<std::string> head;
  std::vector<Row> rows;
};

std::string ToMarkdown(const TextTable& table);
/// A `table*` of a LaTeX article; needs no package.
std::string ToLatex(const TextTable& table);
std::string ToHtml(const TextTable& table);
/// Columns under each other, for a terminal.
std::string ToPlain(const TextTable& table);

/// RFC 4180: quoted where it has to be.
std::string CsvLine(const std::vector<std::string>& cells);

}  // namespace citrine::logs
