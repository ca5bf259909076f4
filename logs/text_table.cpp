#include "logs/text_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "logs/html_text.h"

namespace citrine::logs {
namespace {

using Style = TextTable::Row::Style;

std::string Replaced(std::string text, const std::vector<std::pair<std::string, std::string>>& replacements) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    bool replaced = false;
    for (const auto& [from, to] : replacements)
      if (!replaced && text.compare(i, from.size(), from) == 0) {
        out += to;
        i += from.size();
        replaced = true;
      }
    if (!replaced) out += text[i++];
  }
  return out;
}

std::string Latex(const std::string& text) {
  return Replaced(text, {{"\\", "\\textbackslash{}"},
                         {"&", "\\&"},
                         {"%", "\\%"},
                         {"$", "\\$"},
                         {"#", "\\#"},
                         {"_", "\\_"},
                         {"{", "\\{"},
                         {"}", "\\}"},
                         {"^", "\\textasciicircum{}"},
                         {"~", "\\textasciitilde{}"},
                         {"<", "$<$"},
                         {">", "$>$"},
                         {"±", "$\\pm$"},
                         {"−", "$-$"},
                         {"–", "--"},
                         {"×", "$\\times$"}});
}

std::string Wrapped(const std::string& text, Style style, const std::array<const char*, 2>& bold,
                    const std::array<const char*, 2>& italic) {
  if (text.empty() || style == Style::kPlain) return text;
  const auto& [open, close] = style == Style::kEmphasised ? bold : italic;
  return open + text + close;
}

std::string MarkdownCell(const std::string& text, Style style) {
  return Wrapped(Replaced(text, {{"|", "\\|"}, {"*", "\\*"}, {"_", "\\_"}}), style, {"**", "**"}, {"*", "*"});
}

/// UTF-8: bytes that begin a letter.
std::size_t LettersOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string ToMarkdown(const TextTable& table) {
  std::string text = table.caption.empty() ? "" : table.caption + "\n\n";
  std::string rule = "|";
  text += "|";
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    text += " " + MarkdownCell(table.head[i], Style::kPlain) + " |";
    rule += i == 0 ? "---|" : "--:|";
  }
  text += "\n" + rule + "\n";
  for (const TextTable::Row& row : table.rows) {
    text += "|";
    for (const std::string& cell : row.cells) text += " " + MarkdownCell(cell, row.style) + " |";
    text += "\n";
  }
  return text;
}

std::string ToLatex(const TextTable& table) {
  std::string text = "\\begin{table*}[t]\n\\centering\n\\footnotesize\n\\begin{tabular}{l|" +
                     std::string(table.head.empty() ? 0 : table.head.size() - 1, 'c') + "}\n\\hline\n";
  const auto line = [&](const std::vector<std::string>& cells, Style style) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += (i == 0 ? "" : " & ") + Wrapped(Latex(cells[i]), style, {"\\textbf{", "}"}, {"\\textit{", "}"});
    text += " \\\\\n";
  };
  line(table.head, Style::kPlain);
  text += "\\hline\n";
  for (const TextTable::Row& row : table.rows) line(row.cells, row.style);
  return text + "\\hline\n\\end{tabular}\n\\caption{" + Latex(table.caption) + "}\n\\end{table*}\n";
}

std::string ToHtml(const TextTable& table) {
  std::string html =
      "<div class=\"wide\"><table class=\"sweep\"><caption>" + Escape(table.caption) + "</caption><tr>";
  for (const std::string& cell : table.head) html += "<th>" + Escape(cell) + "</th>";
  html += "</tr>";
  for (const TextTable::Row& row : table.rows) {
    html += row.style == Style::kEmphasised ? "<tr class=\"ours\">" : "<tr>";
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      html +=
          (i == 0 ? "<th>" : "<td>") +
          Wrapped(Replaced(Escape(row.cells[i]), {{" [", "<br/>["}}), row.style, {"", ""}, {"<i>", "</i>"}) +
          (i == 0 ? "</th>" : "</td>");
    html += "</tr>";
  }
  return html + "</table></div>\n";
}

std::string ToPlain(const TextTable& table) {
  std::vector<std::vector<std::string>> lines = {table.head};
  for (const TextTable::Row& row : table.rows) lines.push_back(row.cells);
  std::vector<std::size_t> widths(table.head.size(), 0);
  for (const auto& cells : lines)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], LettersOf(cells[i]));
  std::string text = table.caption + "\n";
  for (const auto& cells : lines) {
    std::string line = " ";
    for (std::size_t i = 0; i < cells.size(); ++i)
      line += " " + cells[i] + std::string(widths[i] - LettersOf(cells[i]) + 1, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string CsvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string& cell = cells[i];
    line += i == 0 ? "" : ",";
    if (cell.find_first_of(",\"\r\n") == std::string::npos)
      line += cell;
    else
      line += "\"" + Replaced(cell, {{"\"", "\"\""}}) + "\"";
  }
  return line + "\n";
}

}  // namespace citrine::logs
