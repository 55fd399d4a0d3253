#include "page.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/draw.hpp"
#include "analysis/page/page.hpp"
#include "drawing.hpp"
#include "exit_code.hpp"
#include "interrupt.hpp"
#include "pages/animation.hpp"
#include "rocking/base/error.hpp"
#include "rocking/text/files.hpp"

namespace rocking::program {
namespace {

/// The motions in the page of a run; none without its store and the files that its experiment names.
analysis::ShownAnimations animations_of(const RunFolder& folder, const Report& report) {
  if (!folder.has_store()) return pages::no_animations("realisations.sqlite was not beside the report");
  const Store store = folder.open_store(sqlite::Access::read);
  std::optional<Experiment> experiment;
  try {
    experiment = experiment_of(store.identity());
  } catch (const base::InputError&) {
    return pages::no_animations("a file that the experiment names has changed");
  } catch (const base::FolderError&) {
    return pages::no_animations("a file that the experiment names is missing");
  }
  return pages::animations_of(*experiment, store, report);
}

}  // namespace

DrawingFailures write_page(const RunFolder& folder, const Report& report, const std::optional<HazardCurve>& hazard) {
  std::vector<analysis::DrawnFigure> figures;
  DrawingFailures failures;
  for (analysis::Figure& figure : figures_of(folder, report, hazard)) {
    analysis::Drawing drawing;
    std::string svg = analysis::picture_of(figure, "svg", drawing, stop_on_signal());
    failures.add(drawing);
    figures.push_back({.figure = std::move(figure), .svg = std::move(svg)});
  }
  write_atomically(folder.page_path(), analysis::page_text(report, figures, animations_of(folder, report)));
  return failures;
}

}  // namespace rocking::program
