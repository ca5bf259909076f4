#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/config/config.h"

namespace citrine {

/// [sweep]: what holds for all of its missions
struct SweepSection {
  std::string name;
  std::string title;
  std::vector<int> seeds = {1, 2, 3};
  std::vector<std::string> set;
  std::string baseline;
  std::vector<std::string> columns;
  std::vector<std::string> over_time;
  std::string x_label;
  bool keep_logs = false;

  template <class V>
  void Visit(V& v) {
    v("name", name, Key{"short name; its results are in results/sweeps/<name>"});
    v("title", title, Key{"headline of its tables; default: the name"});
    v("seeds", seeds, Key{"every world and variant is flown with each"});
    v("set", set, Key{"section.key=value for all missions"});
    v("baseline", baseline, Key{"the variant that others are compared with; default: the first"});
    v("columns", columns, Key{"keys of metrics.json that the tables show; default: those of the paper"});
    v("over_time", over_time, Key{"columns of progress.csv that are drawn over time"});
    v("x_label", x_label, Key{"what the variants' x means; there are plots over it then"});
    v("keep_logs", keep_logs, Key{"keep recordings, meshes and octrees: 100 MB a mission"});
  }
};

/// What every row of a sweep has.
struct SweepRow {
  std::string name;   ///< of the folder of its runs
  std::string title;  ///< in tables
  std::vector<std::string> set;

  template <class V>
  void Visit(V& v) {
    v("name", name, Key{"folder of its runs; of a world by default the mission's name"});
    v("title", title, Key{"as tables have it; default: the name"});
    v("set", set, Key{"section.key=value for its missions"});
  }
};

/// One [[world]] of a sweep: a mission, or another world flown with it
struct SweepWorld : SweepRow {
  std::string mission;
  std::string world;
  std::string paper;
  bool optional = false;

  template <class V>
  void Visit(V& v) {
    SweepRow::Visit(v);
    v("mission", mission, Key{"a name in missions/ or a file"});
    v("world", world, Key{"another world than the mission's, as of `run --world`; relative to the project"});
    v("paper", paper, Key{"the world of the paper's table II to stand beside: house or structure"});
    v("optional", optional, Key{"left out, with a word, where its world's file is not there"});
  }
};

/// One [[variant]] of a sweep: what is compared
struct SweepVariant : SweepRow {
  std::optional<double> x;

  template <class V>
  void Visit(V& v) {
    SweepRow::Visit(v);
    v("x", x, Key{"where it stands in plots over x"});
  }
};

/// A sweep file: every world with every variant and every seed.
struct SweepPlan {
  SweepSection sweep;
  std::vector<SweepWorld> worlds;
  std::vector<SweepVariant> variants;
};

/// Reads a sweep file's text; names, titles and the baseline are filled in.
/// @throws ConfigError naming the key's path, its value and what is allowed
SweepPlan ParseSweep(const std::string& toml_text);

/// "1-3,7" as 1, 2, 3, 7. @throws ConfigError naming what is no seed
std::vector<int> ParseSeeds(const std::string& text);

}  // namespace citrine
