#pragma once

#include "logs/sweep_results.h"

namespace citrine::logs {

inline SweepRun RunOf(const std::string& world, const std::string& variant, int seed, double makespan_m) {
  SweepRun run{world, variant, seed, {}, {}};
  run.metrics.makespan_m = makespan_m;
  run.metrics.seed = seed;
  run.metrics.completed = true;
  run.metrics.stop_reason = "surface_complete";
  run.metrics.collisions = 0;
  return run;
}

/// Two variants in the House, three seeds each, of which two are common: "b" flies 10, then 12 m less.
inline SweepResults SweepOfTwo() {
  SweepResults results;
  results.plan = ParseSweep(
      "[sweep]\nname = \"two\"\ncolumns = [\"makespan_m\", \"coverage_pct\"]\nseeds = [1, 2, 3, 4]\n"
      "[[world]]\nmission = \"house\"\npaper = \"house\"\n"
      "[[variant]]\nname = \"a\"\n[[variant]]\nname = \"b\"\n");
  results.runs = {RunOf("house", "a", 1, 100), RunOf("house", "a", 2, 200), RunOf("house", "a", 3, 300),
                  RunOf("house", "b", 2, 190), RunOf("house", "b", 3, 288), RunOf("house", "b", 4, 50)};
  results.runs[5].metrics.completed = false;
  results.runs[5].metrics.collisions = 2;
  results.command = "./citrine sweep two";
  results.notes = {"Flown in the rain."};
  return results;
}

}  // namespace citrine::logs
