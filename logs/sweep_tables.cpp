#include "logs/sweep_tables.h"

#include <algorithm>
#include <cmath>

#include "logs/metric_number.h"
#include "logs/number_text.h"
#include "logs/paper_results.h"

namespace citrine::logs {
namespace {

using Style = TextTable::Row::Style;

std::string WithDeviation(const Summary& summary, int decimals) {
  const std::string mean = Fixed(summary.mean, decimals);
  return summary.count < 2 ? mean : mean + " ± " + Fixed(summary.deviation, decimals);
}

std::string Signed(double value, int decimals) {
  const std::string text = Fixed(value, decimals);
  if (text.front() == '-') return "−" + text.substr(1);
  return value > 0 ? "+" + text : text;
}

std::string WithInterval(const PairedDifference& pair, int decimals) {
  const Summary& d = pair.difference;
  std::string text = Signed(d.mean, decimals);
  if (d.count < 2) return text;
  text +=
      " [" + Signed(d.mean - d.half_width, decimals) + ", " + Signed(d.mean + d.half_width, decimals) + "]";
  return pair.significant() ? text + " *" : text;
}

std::string Share(std::size_t part, std::size_t whole) {
  return std::to_string(part) + "/" + std::to_string(whole);
}

std::vector<std::string> HeadWith(const std::vector<std::string>& first, const SweepPlan& plan) {
  std::vector<std::string> head = first;
  for (const std::string& column : ColumnsOf(plan)) head.push_back(HeadOf(column));
  return head;
}

/// What the paper says under a key, or a dash.
std::string PaperCell(const PaperResult& paper, const std::string& key) {
  if (key == "makespan_m") return Fixed(paper.makespan_m, 1);
  if (key == "average_path_m") return Fixed(paper.average_path_m, 1);
  if (key == "coverage_pct") return Fixed(paper.coverage_pct, 2);
  if (key == "precision_pct") return Fixed(paper.precision_pct, 2);
  if (key == "f_score_pct") return Fixed(paper.f_score_pct, 2);
  return "–";
}

TextTable::Row PaperRow(const PaperResult& paper, const SweepPlan& plan) {
  TextTable::Row row{{std::string(paper.method), "–", "–"}, Style::kQuoted};
  for (const std::string& column : ColumnsOf(plan)) row.cells.push_back(PaperCell(paper, column));
  return row;
}

std::string Number(double value) { return std::isfinite(value) ? Fixed(value, 6) : ""; }

/// What all of it is about, above and below the tables.
std::string Preface(const SweepResults& results) {
  return "# " + results.plan.sweep.title + "\n\n```sh\n" + results.command + "\n```\n\n";
}

}  // namespace

TextTable MeansTable(const SweepResults& results, const SweepWorld& world) {
  TextTable table{world.title + ": mean ± standard deviation over seeds",
                  HeadWith({"Method", "Completed", "Collisions"}, results.plan),
                  {}};
  for (const SweepVariant& variant : results.plan.variants) {
    const auto runs = RunsOf(results, world.name, variant.name);
    if (runs.empty()) continue;
    const auto completed =
        std::count_if(runs.begin(), runs.end(), [](auto* run) { return run->metrics.completed; });
    double collisions = 0;
    for (const double value : ValuesOf(runs, "collisions")) collisions += value;
    TextTable::Row row{
        {variant.title, Share(static_cast<std::size_t>(completed), runs.size()), Fixed(collisions, 0)},
        variant.name == results.plan.sweep.baseline ? Style::kEmphasised : Style::kPlain};
    for (const std::string& column : ColumnsOf(results.plan))
      row.cells.push_back(WithDeviation(Summarise(ValuesOf(runs, column)), LabelOf(column).decimals));
    table.rows.push_back(row);
  }
  if (table.rows.empty()) return table;
  for (const PaperResult& paper : kPaperResults)
    if (paper.world == world.paper) table.rows.push_back(PaperRow(paper, results.plan));
  return table;
}

TextTable DifferencesTable(const SweepResults& results, const SweepWorld& world) {
  const std::string& baseline = results.plan.sweep.baseline;
  TextTable table{
      world.title + ": difference to " + baseline + ", seed by seed, with its 95 % confidence interval",
      HeadWith({"Method", "Pairs"}, results.plan),
      {}};
  const auto base = RunsOf(results, world.name, baseline);
  for (const SweepVariant& variant : results.plan.variants) {
    if (variant.name == baseline) continue;
    const auto runs = RunsOf(results, world.name, variant.name);
    TextTable::Row row{{variant.title, ""}, Style::kPlain};
    std::size_t pairs = 0;
    for (const std::string& column : ColumnsOf(results.plan)) {
      const PairedDifference pair = PairBySeed(base, runs, column);
      pairs = std::max(pairs, pair.difference.count);
      row.cells.push_back(WithInterval(pair, LabelOf(column).decimals));
    }
    row.cells[1] = std::to_string(pairs);
    if (pairs > 0) table.rows.push_back(row);
  }
  return table;
}

std::string RunsCsv(const SweepResults& results) {
  std::vector<std::string> head = {"world", "variant", "stop_reason", "log_digest", "world_hash", "commit"};
  const std::vector<std::string> keys = NumberKeys();
  head.insert(head.end(), keys.begin(), keys.end());
  std::string csv = CsvLine(head);
  for (const SweepRun& run : results.runs) {
    const Metrics& m = run.metrics;
    std::vector<std::string> cells = {run.world,
                                      run.variant,
                                      m.stop_reason,
                                      m.log_digest.value_or(""),
                                      m.world_hash.value_or(""),
                                      m.commit.value_or("")};
    for (const std::string& key : keys) {
      const auto value = MetricNumber(m, key);
      cells.push_back(value ? Number(*value) : "");
    }
    csv += CsvLine(cells);
  }
  return csv;
}

std::string SummaryCsv(const SweepResults& results) {
  std::string csv = CsvLine({"world", "variant", "metric", "runs", "mean", "deviation", "pairs",
                             "difference_to_baseline", "ci95_low", "ci95_high", "p"});
  for (const SweepWorld& world : results.plan.worlds) {
    const auto base = RunsOf(results, world.name, results.plan.sweep.baseline);
    for (const SweepVariant& variant : results.plan.variants) {
      const auto runs = RunsOf(results, world.name, variant.name);
      for (const std::string& column : ColumnsOf(results.plan)) {
        const Summary s = Summarise(ValuesOf(runs, column));
        const PairedDifference pair = PairBySeed(base, runs, column);
        const Summary& d = pair.difference;
        if (s.count > 0)
          csv += CsvLine({world.name, variant.name, column, std::to_string(s.count), Number(s.mean),
                          Number(s.deviation), std::to_string(d.count), Number(d.mean),
                          Number(d.mean - d.half_width), Number(d.mean + d.half_width), Number(pair.p)});
      }
    }
  }
  return csv;
}

std::string SweepMarkdown(const SweepResults& results) {
  std::string text = Preface(results);
  for (const SweepWorld& world : results.plan.worlds)
    for (const TextTable& table : {MeansTable(results, world), DifferencesTable(results, world)})
      if (!table.rows.empty()) text += ToMarkdown(table) + "\n";
  for (const std::string& note : results.notes) text += "- " + note + "\n";
  return text;
}

std::string SweepLatex(const SweepResults& results) {
  std::string text = "% " + results.plan.sweep.title + ": made by " + results.command + "\n";
  for (const SweepWorld& world : results.plan.worlds)
    for (const TextTable& table : {MeansTable(results, world), DifferencesTable(results, world)})
      if (!table.rows.empty()) text += ToLatex(table) + "\n";
  return text;
}

}  // namespace citrine::logs
