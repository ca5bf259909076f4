#include "logs/sweep_results.h"

#include "logs/metric_number.h"

namespace citrine::logs {

std::vector<const SweepRun*> RunsOf(const SweepResults& results, const std::string& world,
                                    const std::string& variant) {
  std::vector<const SweepRun*> runs;
  for (const SweepRun& run : results.runs)
    if (run.world == world && run.variant == variant) runs.push_back(&run);
  return runs;
}

std::vector<double> ValuesOf(const std::vector<const SweepRun*>& runs, const std::string& key) {
  std::vector<double> values;
  for (const SweepRun* run : runs)
    if (const auto value = MetricNumber(run->metrics, key)) values.push_back(*value);
  return values;
}

PairedDifference PairBySeed(const std::vector<const SweepRun*>& a, const std::vector<const SweepRun*>& b,
                            const std::string& key) {
  std::map<int, double> value_by_seed;
  for (const SweepRun* run : a)
    if (const auto value = MetricNumber(run->metrics, key)) value_by_seed[run->seed] = *value;
  std::vector<double> of_a, of_b;
  for (const SweepRun* run : b) {
    const auto value = MetricNumber(run->metrics, key);
    const auto partner = value_by_seed.find(run->seed);
    if (!value || partner == value_by_seed.end()) continue;
    of_a.push_back(partner->second);
    of_b.push_back(*value);
  }
  return Pair(of_a, of_b);
}

std::vector<std::string> ColumnsOf(const SweepPlan& plan) {
  return plan.sweep.columns.empty() ? PaperColumns() : plan.sweep.columns;
}

}  // namespace citrine::logs
