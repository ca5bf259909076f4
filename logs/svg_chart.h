#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "logs/flight_measures.h"
#include "logs/svg_parts.h"

namespace citrine::logs {

// Figures as inline SVG.

/// One curve of a chart.
struct Curve {
  std::string name;
  Series points;
  int colour = 0;
  bool dashed = false;
  std::vector<double> half_widths = {};  ///< of an interval around each point; empty: none are drawn
};

struct ChartText {
  std::string title, x_label, y_label;
  double y_most =
      std::numeric_limits<double>::infinity();  ///< where the axis ends at the latest, such as 100 %
};

/// Curves over a common pair of axes that begin at zero; long ones are thinned to what the eye can tell
/// apart, extremes kept.
/// @param limit a dashed level with a name, such as v_max
std::string LineChart(const ChartText& text, const std::vector<Curve>& curves,
                      const std::optional<std::pair<std::string, double>>& limit = std::nullopt);
SvgFigure LineFigure(const ChartText& text, const std::vector<Curve>& curves,
                     const std::optional<std::pair<std::string, double>>& limit = std::nullopt);

struct Bar {
  std::string name;
  double value = 0;
  std::string label;  ///< what is printed at its end
  int colour = 0;
};

/// Horizontal bars, in the order given.
std::string BarChart(const std::string& title, const std::vector<Bar>& bars);

/// Paths seen from above at one scale for x and y, in the outline of the mission volume; a ring where each
/// begins, a dot where it ends. @param paths_W [m] one a UAV
std::string PathsFromAbove(const std::string& title, const std::vector<std::vector<Eigen::Vector2d>>& paths_W,
                           const Eigen::AlignedBox2d& volume_W);

}  // namespace citrine::logs
