#include "logs/comparison.h"

#include <cmath>
#include <set>
#include <utility>

#include "logs/metric_number.h"
#include "logs/number_text.h"
#include "logs/statistics.h"
#include "logs/text_table.h"

namespace citrine::logs {
namespace {

using Pairs = std::vector<std::pair<const ComparedRun*, const ComparedRun*>>;

// Where results lie and where the seed has put the starts is no difference of configuration.
const std::set<std::string> kNoDifference = {"launch.out", "mission.spawns_m"};

std::string NameOf(const ComparedRun& run) {
  return run.cell + (run.cell.empty() ? "seed " : " seed ") + std::to_string(run.metrics.seed);
}

/// By cell, those of both sides that have the same seed; two lone runs are a pair whatever their seeds.
std::map<std::string, Pairs> PairUp(const std::vector<ComparedRun>& a, const std::vector<ComparedRun>& b,
                                    std::string& alone) {
  std::map<std::string, Pairs> pairs;
  if (a.size() == 1 && b.size() == 1) {
    pairs[a[0].cell].emplace_back(&a[0], &b[0]);
    return pairs;
  }
  std::map<std::pair<std::string, int>, const ComparedRun*> open;
  for (const ComparedRun& run : b) open[{run.cell, run.metrics.seed}] = &run;
  for (const ComparedRun& run : a) {
    const auto partner = open.find({run.cell, run.metrics.seed});
    if (partner == open.end()) {
      alone += "only in A: " + NameOf(run) + "\n";
      continue;
    }
    pairs[run.cell].emplace_back(&run, partner->second);
    open.erase(partner);
  }
  for (const auto& [key, run] : open) alone += "only in B: " + NameOf(*run) + "\n";
  return pairs;
}

std::string ValueIn(const std::map<std::string, std::string>& config, const std::string& key) {
  const auto found = config.find(key);
  return found == config.end() ? "–" : found->second;
}

/// Keys that differ in any pair; of a sweep all pairs of a cell differ alike, so one stands for them.
TextTable ConfigurationTable(const std::map<std::string, Pairs>& pairs) {
  TextTable table{"Configuration", {"Key", "A", "B"}, {}};
  std::set<std::vector<std::string>> seen;
  for (const auto& [cell, of_cell] : pairs) {
    const auto& [a, b] = of_cell.front();
    std::set<std::string> keys;
    for (const auto& [key, value] : a->config) keys.insert(key);
    for (const auto& [key, value] : b->config) keys.insert(key);
    for (const std::string& key : keys) {
      const std::vector<std::string> row = {key, ValueIn(a->config, key), ValueIn(b->config, key)};
      if (row[1] != row[2] && !kNoDifference.contains(key) && seen.insert(row).second)
        table.rows.push_back({row});
    }
  }
  return table;
}

std::string Cell(const Summary& s, int decimals) {
  return Fixed(s.mean, decimals) + (s.count > 1 ? " ± " + Fixed(s.deviation, decimals) : "");
}

std::string Relative(double difference, double of) {
  return of == 0 ? "–" : Fixed(100 * difference / std::abs(of), 1) + " %";
}

TextTable ResultTable(const std::string& cell, const Pairs& pairs) {
  TextTable table{
      cell.empty() ? "Result" : cell, {"Number", "A", "B", "B - A", "relative", "95 % interval", "p"}, {}};
  for (const std::string& key : NumberKeys()) {
    std::vector<double> of_a, of_b;
    for (const auto& [a, b] : pairs) {
      const auto x = MetricNumber(a->metrics, key), y = MetricNumber(b->metrics, key);
      if (!x || !y) continue;
      of_a.push_back(*x);
      of_b.push_back(*y);
    }
    if (of_a == of_b) continue;
    const Summary a = Summarise(of_a), b = Summarise(of_b);
    const PairedDifference pair = Pair(of_a, of_b);
    const Summary& d = pair.difference;
    const int decimals = LabelOf(key).decimals + 1;
    const std::string low = Fixed(d.mean - d.half_width, decimals),
                      high = Fixed(d.mean + d.half_width, decimals);
    table.rows.push_back({{key, Cell(a, decimals), Cell(b, decimals), Fixed(d.mean, decimals),
                           Relative(d.mean, a.mean), d.count < 2 ? "–" : "[" + low + ", " + high + "]",
                           d.count < 2 ? "–" : Fixed(pair.p, 4) + (pair.significant() ? " *" : "")}});
  }
  return table;
}

std::string Digests(const std::map<std::string, Pairs>& pairs) {
  std::size_t same = 0, all = 0;
  for (const auto& [cell, of_cell] : pairs)
    for (const auto& [a, b] : of_cell) {
      ++all;
      same += a->metrics.log_digest && a->metrics.log_digest == b->metrics.log_digest;
    }
  return std::to_string(same) + " of " + std::to_string(all) + " pairs have the same log digest.\n";
}

std::string Commits(const std::map<std::string, Pairs>& pairs) {
  std::set<std::string> of_a, of_b;
  for (const auto& [cell, of_cell] : pairs)
    for (const auto& [a, b] : of_cell) {
      of_a.insert(a->metrics.commit.value_or("unknown"));
      of_b.insert(b->metrics.commit.value_or("unknown"));
    }
  if (of_a == of_b) return "";
  std::string text = "Commits: A";
  for (const std::string& commit : of_a) text += " " + commit;
  text += "; B";
  for (const std::string& commit : of_b) text += " " + commit;
  return text + ".\n";
}

}  // namespace

std::string Compare(const std::vector<ComparedRun>& a, const std::vector<ComparedRun>& b) {
  std::string alone;
  const std::map<std::string, Pairs> pairs = PairUp(a, b, alone);
  if (pairs.empty()) return alone + "Nothing of A has a partner of the same world, variant and seed in B.\n";
  const TextTable configuration = ConfigurationTable(pairs);
  std::string text = configuration.rows.empty() ? "The configuration is the same.\n" : ToPlain(configuration);
  text += Commits(pairs) + "\n";
  bool lone = false;
  for (const auto& [cell, of_cell] : pairs) {
    const TextTable result = ResultTable(cell, of_cell);
    text += (result.rows.empty() ? result.caption + ": every number is the same.\n" : ToPlain(result)) + "\n";
    lone |= of_cell.size() < 2;
  }
  text += Digests(pairs) + alone;
  text += lone ? "One pair says nothing about significance: fly several seeds with ./citrine sweep.\n"
               : "* p < 0.05: paired t test, not corrected for the number of comparisons.\n";
  return text;
}

}  // namespace citrine::logs
