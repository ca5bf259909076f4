#include "logs/sweep_plots.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "logs/metric_number.h"
#include "logs/paper_results.h"
#include "logs/svg_chart.h"
#include "logs/svg_intervals.h"

namespace citrine::logs {
namespace {

constexpr int kInstants = 200;

/// What fits beside a figure.
std::string ShortName(const SweepVariant& variant) {
  constexpr std::size_t kMostLetters = 18;
  return variant.title.size() <= kMostLetters ? variant.title : variant.name;
}

double MostOf(const std::string& column) {
  return LabelOf(column).unit == "%" ? 100 : std::numeric_limits<double>::infinity();
}

SvgFigure OverTime(const SweepResults& results, const SweepWorld& world, const std::string& column) {
  std::vector<Curve> curves;
  int colour = 0;
  for (const SweepVariant& variant : results.plan.variants) {
    std::vector<const Series*> series;
    for (const SweepRun* run : RunsOf(results, world.name, variant.name))
      if (const auto found = run->over_time.find(column); found != run->over_time.end())
        series.push_back(&found->second);
    if (!series.empty()) curves.push_back({ShortName(variant), MeanOverTime(series, kInstants), colour});
    ++colour;
  }
  return LineFigure({world.title + ": " + column + ", mean over seeds", "mission time [s]", column}, curves);
}

SvgFigure OverX(const SweepResults& results, const SweepWorld& world, const std::string& column) {
  Curve curve{"", {}, 0, false, {}};
  for (const SweepVariant& variant : results.plan.variants) {
    const Summary s = Summarise(ValuesOf(RunsOf(results, world.name, variant.name), column));
    if (s.count == 0 || !variant.x) continue;
    curve.points.emplace_back(*variant.x, s.mean);
    curve.half_widths.push_back(s.half_width);
  }
  return LineFigure({world.title + ": " + HeadOf(column) + ", mean and 95 % interval",
                     results.plan.sweep.x_label, HeadOf(column), MostOf(column)},
                    {curve});
}

std::optional<std::pair<std::string, double>> PaperMark(const std::string& world, const std::string& column) {
  for (const PaperResult& paper : kPaperResults) {
    if (paper.world != world || paper.method != kPaperMethod) continue;
    if (column == "makespan_m") return {{"paper", paper.makespan_m}};
    if (column == "average_path_m") return {{"paper", paper.average_path_m}};
    if (column == "coverage_pct") return {{"paper", paper.coverage_pct}};
    if (column == "precision_pct") return {{"paper", paper.precision_pct}};
    if (column == "f_score_pct") return {{"paper", paper.f_score_pct}};
  }
  return std::nullopt;
}

SvgFigure ByVariant(const SweepResults& results, const SweepWorld& world, const std::string& column) {
  std::vector<IntervalRow> rows;
  int colour = 0;
  for (const SweepVariant& variant : results.plan.variants) {
    const std::vector<double> values = ValuesOf(RunsOf(results, world.name, variant.name), column);
    const Summary s = Summarise(values);
    if (!values.empty()) rows.push_back({ShortName(variant), values, s.mean, s.half_width, colour});
    ++colour;
  }
  return IntervalFigure(world.title + ": " + HeadOf(column), HeadOf(column), rows,
                        PaperMark(world.paper, column), MostOf(column));
}

}  // namespace

Series MeanOverTime(const std::vector<const Series*>& series, int count) {
  double end = 0;
  for (const Series* one : series)
    if (!one->empty()) end = std::max(end, one->back().first);
  Series mean;
  for (int k = 0; k <= count && !series.empty(); ++k) {
    const double t = end * k / count;
    double sum = 0;
    for (const Series* one : series) sum += ValueAt(*one, t);
    mean.emplace_back(t, sum / static_cast<double>(series.size()));
  }
  return mean;
}

std::vector<NamedFigure> SweepFigures(const SweepResults& results) {
  std::vector<NamedFigure> figures;
  for (const SweepWorld& world : results.plan.worlds) {
    const bool flown = std::any_of(results.runs.begin(), results.runs.end(),
                                   [&](const SweepRun& run) { return run.world == world.name; });
    if (!flown) continue;
    for (const std::string& column : results.plan.sweep.over_time)
      figures.push_back({world.name + "-" + column + "-over_time", OverTime(results, world, column)});
    for (const std::string& column : ColumnsOf(results.plan)) {
      if (results.plan.sweep.x_label.empty())
        figures.push_back({world.name + "-" + column, ByVariant(results, world, column)});
      else
        figures.push_back({world.name + "-" + column + "-over_x", OverX(results, world, column)});
    }
  }
  return figures;
}

}  // namespace citrine::logs
