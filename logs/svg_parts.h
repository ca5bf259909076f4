#pragma once

#include <string>
#include <utility>
#include <vector>

namespace citrine::logs {

// What figures are drawn of. Colours are CSS classes c0..c7 of the page, so that they follow its light or
// dark scheme.

inline constexpr int kNumColours = 8;
inline constexpr double kFigureWidth = 460;

/// A figure that stands in a page or in a file of its own.
struct SvgFigure {
  std::string title;
  std::string body;  ///< elements of SVG
  double width = 0, height = 0;
  std::vector<std::pair<std::string, int>> legend;  ///< name and colour
};
std::string ToHtml(const SvgFigure& figure);
/// With title, legend, colours and a page behind it: a picture for any viewer.
std::string ToSvgFile(const SvgFigure& figure);

/// A coordinate, to a tenth.
std::string N(double x);
std::string ColourClass(int colour);
std::string Text(double x, double y, const std::string& text, const std::string& anchor = "middle",
                 const std::string& more = "");
std::string Rule(double x1, double y1, double x2, double y2, const std::string& style);
std::string Dot(double x, double y, double radius, const std::string& style);

/// An axis from zero to a round number above `largest`, with about five ticks 1, 2 or 5 times a power of ten
/// apart.
struct Axis {
  double top = 1, step = 0.2;

  explicit Axis(double largest);
  int decimals() const;
  int ticks() const;
};

}  // namespace citrine::logs
