#include "logs/text_table.h"

#include <gtest/gtest.h>

namespace citrine::logs {
namespace {

using Style = TextTable::Row::Style;

const TextTable kTable{
    "A & B: 100 % of d_s",
    {"Method", "Cov. (%)"},
    {{{"a_b", "1 ± 2"}, Style::kEmphasised}, {{"c|d", "−3"}, Style::kPlain}, {{"<e>", "–"}, Style::kQuoted}}};

TEST(TextTable, IsMarkdownThatNoCellBreaks) {
  EXPECT_EQ(ToMarkdown(kTable),
            "A & B: 100 % of d_s\n\n"
            "| Method | Cov. (%) |\n"
            "|---|--:|\n"
            "| **a\\_b** | **1 ± 2** |\n"
            "| c\\|d | −3 |\n"
            "| *<e>* | *–* |\n");
}

TEST(TextTable, IsLatexWithEveryActiveLetterEscaped) {
  EXPECT_EQ(ToLatex(kTable),
            "\\begin{table*}[t]\n\\centering\n\\footnotesize\n\\begin{tabular}{l|c}\n\\hline\n"
            "Method & Cov. (\\%) \\\\\n\\hline\n"
            "\\textbf{a\\_b} & \\textbf{1 $\\pm$ 2} \\\\\n"
            "c|d & $-$3 \\\\\n"
            "\\textit{$<$e$>$} & \\textit{--} \\\\\n"
            "\\hline\n\\end{tabular}\n\\caption{A \\& B: 100 \\% of d\\_s}\n\\end{table*}\n");
}

TEST(TextTable, IsHtmlWithEveryTagEscaped) {
  const std::string html = ToHtml(kTable);
  EXPECT_NE(html.find("<caption>A &amp; B: 100 % of d_s</caption>"), std::string::npos);
  EXPECT_NE(html.find("<th><i>&lt;e&gt;</i></th>"), std::string::npos);
}

TEST(TextTable, StandsInColumnsWhateverTheBytesOfALetter) {
  EXPECT_EQ(ToPlain(kTable),
            "A & B: 100 % of d_s\n"
            "  Method  Cov. (%)\n"
            "  a_b     1 ± 2\n"
            "  c|d     −3\n"
            "  <e>     –\n");
}

TEST(TextTable, CsvQuotesWhatHoldsACommaAQuoteOrALineEnd) {
  EXPECT_EQ(CsvLine({"a", "b,c", "d\"e", "f\ng", ""}), "a,\"b,c\",\"d\"\"e\",\"f\ng\",\n");
}

}  // namespace
}  // namespace citrine::logs
