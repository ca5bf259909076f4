#include "logs/svg_parts.h"

#include <algorithm>
#include <cmath>

#include "logs/html_text.h"
#include "logs/number_text.h"
#include "logs/page_style.h"

namespace citrine::logs {
namespace {

double TickStep(double top) {
  const double raw = top / 5;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * 1.0001) return factor * power;
  return 10 * power;
}

std::string HtmlLegend(const std::vector<std::pair<std::string, int>>& legend) {
  if (legend.empty()) return "";
  std::string html = "<span class=\"legend\">";
  for (const auto& [name, colour] : legend)
    html += "<span class=\"" + ColourClass(colour) + "\"><i></i>" + Escape(name) + "</span>";
  return html + "</span>";
}

}  // namespace

std::string ToHtml(const SvgFigure& figure) {
  return "<figure><figcaption>" + Escape(figure.title) + HtmlLegend(figure.legend) +
         "</figcaption><svg viewBox=\"0 0 " + N(figure.width) + " " + N(figure.height) +
         "\" role=\"img\" aria-label=\"" + Escape(figure.title) + "\">" + figure.body + "</svg></figure>\n";
}

std::string ToSvgFile(const SvgFigure& figure) {
  constexpr double kRow = 16, kHead = 24, kMargin = 8;
  const double above = kHead + kRow * static_cast<double>(figure.legend.size());
  const double height = figure.height + above;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + N(figure.width) + " " +
                    N(height) + "\" width=\"" + N(1.5 * figure.width) + "\" height=\"" + N(1.5 * height) +
                    "\">\n<style>" + SvgStyle() +
                    "</style>\n<rect class=\"page\" width=\"100%\" height=\"100%\"/>";
  svg += Text(kMargin, kHead - 8, figure.title, "start", " class=\"head\"");
  double y = kHead;
  for (const auto& [name, colour] : figure.legend) {
    svg += Rule(kMargin, y + kRow / 2, kMargin + 16, y + kRow / 2, "curve " + ColourClass(colour));
    svg += Text(kMargin + 22, y + kRow / 2 + 4, name, "start");
    y += kRow;
  }
  return svg + "<g transform=\"translate(0 " + N(above) + ")\">" + figure.body + "</g></svg>\n";
}

std::string N(double x) { return Fixed(x, 1); }

std::string ColourClass(int colour) { return "c" + std::to_string(colour % kNumColours); }

std::string Text(double x, double y, const std::string& text, const std::string& anchor,
                 const std::string& more) {
  return "<text x=\"" + N(x) + "\" y=\"" + N(y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
         Escape(text) + "</text>";
}

std::string Rule(double x1, double y1, double x2, double y2, const std::string& style) {
  return "<line class=\"" + style + "\" x1=\"" + N(x1) + "\" y1=\"" + N(y1) + "\" x2=\"" + N(x2) +
         "\" y2=\"" + N(y2) + "\"/>";
}

std::string Dot(double x, double y, double radius, const std::string& style) {
  return "<circle class=\"" + style + "\" cx=\"" + N(x) + "\" cy=\"" + N(y) + "\" r=\"" + N(radius) + "\"/>";
}

Axis::Axis(double largest) {
  step = TickStep(largest > 0 ? largest : 1);
  top = step * std::ceil((largest > 0 ? largest : 1) / step - 1e-9);
}
int Axis::decimals() const { return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9))); }
int Axis::ticks() const { return static_cast<int>(std::lround(top / step)); }

}  // namespace citrine::logs
