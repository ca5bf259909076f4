#include "logs/sweep_html.h"

#include "logs/html_text.h"
#include "logs/page_style.h"
#include "logs/sweep_tables.h"

namespace citrine::logs {

std::string SweepHtml(const SweepResults& results, const std::vector<NamedFigure>& figures) {
  std::string html = PageHead(results.plan.sweep.title);
  html += "<pre>" + Escape(results.command) + "</pre>\n";
  for (const SweepWorld& world : results.plan.worlds)
    for (const TextTable& table : {MeansTable(results, world), DifferencesTable(results, world)})
      if (!table.rows.empty()) html += ToHtml(table);
  html += "<ul class=\"soft\">";
  for (const std::string& note : results.notes) html += "<li>" + Escape(note) + "</li>";
  html += "</ul>\n<div class=\"figures\">\n";
  for (const NamedFigure& figure : figures) html += ToHtml(figure.figure);
  return html + "</div>\n</body>\n</html>\n";
}

}  // namespace citrine::logs
