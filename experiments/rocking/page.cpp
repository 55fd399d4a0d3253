#include "page.hpp"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/draw.hpp"
#include "analysis/page/page.hpp"
#include "drawing.hpp"
#include "interrupt.hpp"
#include "rocking/report/files.hpp"

namespace rocking::program {

void write_page(const RunFolder& folder, const analysis::RunReport& report, const Loudness& loudness) {
  std::vector<analysis::DrawnFigure> figures;
  std::set<std::string> reasons;
  for (analysis::Figure& figure : figures_of(folder, report)) {
    analysis::Drawing drawing;
    std::string svg = analysis::svg_of(figure, drawing, stop_on_signal());
    if (!drawing.drawn) reasons.insert(drawing.reason);
    figures.push_back({.figure = std::move(figure), .svg = std::move(svg)});
  }
  report::write_atomically(folder.page_path(), analysis::page_text(report, figures));
  if (loudness.quiet) return;
  for (const std::string& reason : reasons) print_notice("report.html has no pictures for paper: " + reason);
}

}  // namespace rocking::program
