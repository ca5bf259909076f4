#pragma once

#include <array>
#include <string_view>

namespace citrine::logs {

/// One row of table II of the paper, for one world: means over ten runs with three UAVs.
struct PaperResult {
  std::string_view world, method;
  double makespan_m, average_path_m, coverage_pct, precision_pct, f_score_pct;
};

inline constexpr std::string_view kPaperMethod = "paper (d* = 4.5 m)";
inline constexpr std::string_view kPaperMethodUnbalanced = "paper, no imbalance correction";

inline constexpr std::array<PaperResult, 8> kPaperResults{{
    {"house", kPaperMethod, 258.2, 200.9, 80.73, 69.06, 74.44},
    {"house", kPaperMethodUnbalanced, 329, 260, 81.6, 69.13, 74.84},
    {"house", "FAME", 457, 274, 43.63, 37.25, 40.18},
    {"house", "RACER", 430, 262, 41.66, 37.35, 39.38},
    {"structure", kPaperMethod, 289.4, 236.6, 95.48, 87.03, 91.06},
    {"structure", kPaperMethodUnbalanced, 336, 279, 96.03, 87.01, 91.29},
    {"structure", "FAME", 586, 371, 78.23, 70.69, 74.26},
    {"structure", "RACER", 544, 434, 74.94, 73.83, 74.38},
}};

}  // namespace citrine::logs
