#include "page.hpp"

#include <string>
#include <utility>
#include <vector>

#include "analysis/draw.hpp"
#include "analysis/page/page.hpp"
#include "animation.hpp"
#include "drawing.hpp"
#include "interrupt.hpp"
#include "rocking/text/files.hpp"

namespace rocking::program {

DrawingFailures write_page(const RunFolder& folder, const analysis::RunReport& report) {
  std::vector<analysis::DrawnFigure> figures;
  DrawingFailures failures;
  for (analysis::Figure& figure : figures_of(folder, report)) {
    analysis::Drawing drawing;
    std::string svg = analysis::svg_of(figure, drawing, stop_on_signal());
    failures.add(drawing);
    figures.push_back({.figure = std::move(figure), .svg = std::move(svg)});
  }
  write_atomically(folder.page_path(), analysis::page_text(report, figures, animations_of(folder, report)));
  return failures;
}

}  // namespace rocking::program
