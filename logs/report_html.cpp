#include "logs/report_html.h"

#include "logs/decision_plots.h"
#include "logs/html_text.h"
#include "logs/page_style.h"
#include "logs/report_plots.h"
#include "logs/report_tables.h"

namespace citrine::logs {
namespace {

std::string Section(const std::string& title, const std::string& grid_class, const std::string& content) {
  if (content.empty()) return "";
  return "<h2>" + title + "</h2>\n<div class=\"" + grid_class + "\">\n" + content + "</div>\n";
}

std::string Notes(const std::vector<std::string>& notes) {
  std::string html;
  for (const std::string& note : notes) html += "<li>" + Escape(note) + "</li>";
  return html.empty() ? "" : "<ul class=\"soft\">" + html + "</ul>\n";
}

std::string Picture(const std::string& title, const std::string& alt, const std::vector<std::uint8_t>& png) {
  if (png.empty()) return "";
  return "<h2>" + title + "</h2>\n<img alt=\"" + alt + "\" src=\"data:image/png;base64," + Base64(png) +
         "\"/>\n";
}

}  // namespace

std::string ReportHtml(const ReportPage& page) {
  const Metrics& m = page.metrics;
  const std::string title = m.mission + " · " + m.strategy + " · seed " + std::to_string(m.seed);
  std::string html = PageHead(title);
  html += "<p class=\"soft\">" + Escape(m.world) + " · " + std::to_string(m.uavs) + " UAVs</p>\n";
  html += VerdictLine(page) + PaperTable(page) + Notes(page.notes);
  html += Section("Numbers", "tables", NumberTables(page));
  html += Picture("From above", "the map from above at the end", page.topdown_png);
  html += Picture("Mesh", "the reconstructed surface", page.mesh_png);
  html += Section("Flight", "figures", FlightPlots(page) + DecisionPlots(page));
  html += Section("Map", "figures", CoveragePlot(page) + ProgressPlots(page.record));
  html += Section("System", "figures", SystemPlots(page.record));
  if (!page.command.empty()) html += "<h2>Fly it again</h2>\n<pre>" + Escape(page.command) + "</pre>\n";
  html += "<h2>Configuration</h2>\n<pre>" + Escape(page.config_toml) + "</pre>\n</body>\n</html>\n";
  return html;
}

}  // namespace citrine::logs
