#include "logs/svg_chart.h"

#include <algorithm>
#include <cmath>

#include "logs/number_text.h"
#include "logs/svg_parts.h"

namespace citrine::logs {
namespace {

constexpr double kHeight = 240;
constexpr double kLeft = 54, kRight = 12, kTop = 12, kBottom = 40;
constexpr std::size_t kBucketsPerCurve = 300;

/// The first, lowest, highest and last sample of each of kBucketsPerCurve equal runs.
Series Thinned(const Series& points) {
  if (points.size() <= 4 * kBucketsPerCurve) return points;
  Series thin;
  const auto by_value = [](const auto& a, const auto& b) { return a.second < b.second; };
  for (std::size_t b = 0; b < kBucketsPerCurve; ++b) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(b * points.size() / kBucketsPerCurve);
    const auto last =
        points.begin() + static_cast<std::ptrdiff_t>((b + 1) * points.size() / kBucketsPerCurve);
    auto [low, high] = std::minmax_element(first, last, by_value);
    if (high < low) std::swap(low, high);
    thin.push_back(*low);
    if (high != low) thin.push_back(*high);
  }
  thin.push_back(points.back());
  return thin;
}

struct Plane {
  Axis x, y;
  double Px(double value) const { return kLeft + value / x.top * (kFigureWidth - kLeft - kRight); }
  double Py(double value) const { return kHeight - kBottom - value / y.top * (kHeight - kTop - kBottom); }
};

std::string Axes(const Plane& plane, const ChartText& text) {
  std::string svg;
  for (int k = 0; k <= plane.y.ticks(); ++k) {
    const double value = k * plane.y.step;
    svg += Rule(kLeft, plane.Py(value), kFigureWidth - kRight, plane.Py(value), k == 0 ? "axis" : "grid");
    svg += Text(kLeft - 6, plane.Py(value) + 4, Fixed(value, plane.y.decimals()), "end");
  }
  for (int k = 0; k <= plane.x.ticks(); ++k) {
    const double value = k * plane.x.step;
    svg += Rule(plane.Px(value), kHeight - kBottom, plane.Px(value), kHeight - kBottom + 4, "axis");
    svg += Text(plane.Px(value), kHeight - kBottom + 16, Fixed(value, plane.x.decimals()));
  }
  svg += Text((kLeft + kFigureWidth - kRight) / 2, kHeight - 6, text.x_label);
  svg += Text(0, 0, text.y_label, "middle",
              " transform=\"translate(12 " + N((kTop + kHeight - kBottom) / 2) + ") rotate(-90)\"");
  return svg;
}

std::string Polyline(const Plane& plane, const Curve& curve) {
  std::string points;
  for (const auto& [x, y] : Thinned(curve.points))
    if (std::isfinite(y)) points += N(plane.Px(x)) + "," + N(plane.Py(y)) + " ";
  return "<polyline class=\"curve " + ColourClass(curve.colour) + (curve.dashed ? " dashed" : "") +
         "\" points=\"" + points + "\"/>";
}

double HalfWidth(const Curve& curve, std::size_t k) {
  return k < curve.half_widths.size() && std::isfinite(curve.half_widths[k]) ? curve.half_widths[k] : 0;
}

/// A bar from low to high at each point that has an interval, and a dot at all points of such a curve.
std::string Intervals(const Plane& plane, const Curve& curve) {
  std::string svg;
  for (std::size_t k = 0; k < curve.half_widths.size() && k < curve.points.size(); ++k) {
    const auto& [x, y] = curve.points[k];
    const double half = HalfWidth(curve, k);
    svg += Rule(plane.Px(x), plane.Py(std::max(y - half, 0.0)), plane.Px(x),
                plane.Py(std::min(y + half, plane.y.top)), "curve " + ColourClass(curve.colour));
    svg += Dot(plane.Px(x), plane.Py(y), 3, "dot " + ColourClass(curve.colour));
  }
  return svg;
}

}  // namespace

SvgFigure LineFigure(const ChartText& text, const std::vector<Curve>& curves,
                     const std::optional<std::pair<std::string, double>>& limit) {
  double right = 0, top = limit ? limit->second : 0;
  for (const Curve& curve : curves)
    for (std::size_t k = 0; k < curve.points.size(); ++k)
      if (const auto& [x, y] = curve.points[k]; std::isfinite(y))
        right = std::max(right, x), top = std::max(top, y + HalfWidth(curve, k));
  const Plane plane{Axis(right), Axis(std::min(top, text.y_most))};

  std::string svg = Axes(plane, text);
  std::vector<std::pair<std::string, int>> names;
  for (const Curve& curve : curves) {
    svg += Polyline(plane, curve) + Intervals(plane, curve);
    names.emplace_back(curve.name, curve.colour);
  }
  if (limit) {
    svg += Rule(kLeft, plane.Py(limit->second), kFigureWidth - kRight, plane.Py(limit->second), "limit");
    svg += Text(kFigureWidth - kRight, plane.Py(limit->second) - 4, limit->first, "end");
  }
  if (curves.size() < 2) names.clear();
  return {text.title, svg, kFigureWidth, kHeight, names};
}

std::string LineChart(const ChartText& text, const std::vector<Curve>& curves,
                      const std::optional<std::pair<std::string, double>>& limit) {
  return ToHtml(LineFigure(text, curves, limit));
}

std::string BarChart(const std::string& title, const std::vector<Bar>& bars) {
  constexpr double kRow = 22, kNames = 150, kLabels = 110;
  double largest = 0;
  for (const Bar& bar : bars) largest = std::max(largest, bar.value);
  std::string svg;
  double y = 4;
  for (const Bar& bar : bars) {
    const double width = largest > 0 ? bar.value / largest * (kFigureWidth - kNames - kLabels) : 0;
    svg += Text(kNames - 8, y + 14, bar.name, "end");
    svg += "<rect class=\"bar " + ColourClass(bar.colour) + "\" x=\"" + N(kNames) + "\" y=\"" + N(y + 3) +
           "\" width=\"" + N(std::max(width, 1.0)) + "\" height=\"" + N(kRow - 8) + "\"/>";
    svg += Text(kNames + width + 6, y + 14, bar.label, "start");
    y += kRow;
  }
  return ToHtml({title, svg, kFigureWidth, y + 4, {}});
}

std::string PathsFromAbove(const std::string& title, const std::vector<std::vector<Eigen::Vector2d>>& paths_W,
                           const Eigen::AlignedBox2d& volume_W) {
  constexpr double kMargin = 16, kSteps = 0.05;
  const Eigen::Vector2d size = volume_W.sizes();
  const double scale = (kFigureWidth - 2 * kMargin) / size.x();
  const double height = size.y() * scale + 2 * kMargin;
  const auto px = [&](const Eigen::Vector2d& p) { return kMargin + (p.x() - volume_W.min().x()) * scale; };
  const auto py = [&](const Eigen::Vector2d& p) {
    return height - kMargin - (p.y() - volume_W.min().y()) * scale;
  };
  const auto dot = [&](const Eigen::Vector2d& p, const std::string& style) {
    return "<circle class=\"" + style + "\" cx=\"" + N(px(p)) + "\" cy=\"" + N(py(p)) + "\" r=\"4\"/>";
  };

  std::string svg = "<rect class=\"frame\" x=\"" + N(kMargin) + "\" y=\"" + N(kMargin) + "\" width=\"" +
                    N(size.x() * scale) + "\" height=\"" + N(size.y() * scale) + "\"/>";
  svg += Text(kMargin + 4, height - kMargin - 6, Fixed(size.x(), 0) + " x " + Fixed(size.y(), 0) + " m",
              "start");
  std::vector<std::pair<std::string, int>> names;
  for (std::size_t i = 0; i < paths_W.size(); ++i) {
    const auto& path = paths_W[i];
    names.emplace_back("UAV " + std::to_string(i + 1), static_cast<int>(i));
    if (path.empty()) continue;
    std::string points;
    Eigen::Vector2d last = path.front() + Eigen::Vector2d(1e9, 0);
    for (const Eigen::Vector2d& p : path) {
      if ((p - last).norm() < kSteps) continue;
      points += N(px(p)) + "," + N(py(p)) + " ";
      last = p;
    }
    const std::string colour = ColourClass(static_cast<int>(i));
    svg += "<polyline class=\"curve " + colour + "\" points=\"" + points + "\"/>";
    svg += dot(path.front(), "ring " + colour) + dot(path.back(), "dot " + colour);
  }
  return ToHtml({title, svg, kFigureWidth, height, names});
}

}  // namespace citrine::logs
