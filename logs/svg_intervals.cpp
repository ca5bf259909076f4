#include "logs/svg_intervals.h"

#include <algorithm>
#include <cmath>

#include "logs/number_text.h"

namespace citrine::logs {
namespace {

constexpr double kNames = 150, kRight = 16, kTop = 14, kRow = 24, kBottom = 38;

}  // namespace

SvgFigure IntervalFigure(const std::string& title, const std::string& x_label,
                         const std::vector<IntervalRow>& rows,
                         const std::optional<std::pair<std::string, double>>& mark, double most) {
  double largest = mark ? mark->second : 0;
  for (const IntervalRow& row : rows) {
    for (const double value : row.values) largest = std::max(largest, value);
    if (std::isfinite(row.half_width)) largest = std::max(largest, row.mean + row.half_width);
  }
  const Axis axis(std::min(largest, most));
  const double bottom = kTop + kRow * static_cast<double>(rows.size());
  const auto px = [&](double value) {
    return kNames + std::clamp(value / axis.top, 0.0, 1.0) * (kFigureWidth - kNames - kRight);
  };

  std::string svg;
  for (int k = 0; k <= axis.ticks(); ++k) {
    const double x = px(k * axis.step);
    svg += Rule(x, kTop, x, bottom, k == 0 ? "axis" : "grid");
    svg += Text(x, bottom + 14, Fixed(k * axis.step, axis.decimals()));
  }
  svg += Text((kNames + kFigureWidth - kRight) / 2, bottom + 30, x_label);
  double y = kTop + kRow / 2;
  for (const IntervalRow& row : rows) {
    const std::string colour = ColourClass(row.colour);
    svg += Text(kNames - 8, y + 4, row.name, "end");
    for (const double value : row.values) svg += Dot(px(value), y, 2.5, "faint " + colour);
    if (std::isfinite(row.half_width))
      svg += Rule(px(row.mean - row.half_width), y, px(row.mean + row.half_width), y, "curve " + colour);
    if (std::isfinite(row.mean)) svg += Dot(px(row.mean), y, 4, "dot " + colour);
    y += kRow;
  }
  if (mark) {
    svg += Rule(px(mark->second), kTop, px(mark->second), bottom, "limit");
    svg += Text(px(mark->second), kTop - 3, mark->first);
  }
  return {title, svg, kFigureWidth, bottom + kBottom, {}};
}

}  // namespace citrine::logs
