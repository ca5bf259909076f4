#include "planner/strategy/strategies.h"

#include "planner/strategy/nearest_frontier.h"
#include "planner/strategy/quality_adaptive.h"

namespace citrine::planner {

namespace {

struct Row {
  const char* name;
  std::unique_ptr<Strategy> (*make)(const PlannerSection& config);
};

const Row kStrategies[] = {
    {"quality_adaptive",
     [](const PlannerSection& config) -> std::unique_ptr<Strategy> {
       return std::make_unique<QualityAdaptive>(ScoreWeights{config.alpha, config.beta, config.gamma});
     }},
    {"nearest_frontier",
     [](const PlannerSection&) -> std::unique_ptr<Strategy> { return std::make_unique<NearestFrontier>(); }},
};

}  // namespace

std::vector<std::string> StrategyNames() {
  std::vector<std::string> names;
  for (const Row& row : kStrategies) names.emplace_back(row.name);
  return names;
}

std::unique_ptr<Strategy> MakeStrategy(const PlannerSection& config) {
  std::string known;
  for (const Row& row : kStrategies) {
    if (config.strategy == row.name) return row.make(config);
    known += std::string(known.empty() ? "" : ", ") + row.name;
  }
  throw ConfigError("planner.strategy = \"" + config.strategy + "\": not one of " + known);
}

}  // namespace citrine::planner
