#include <algorithm>
#include <utility>

#include "analysis/draw.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/studies/fragility/figure.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "rocking/studies/fragility/sheet.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

/// The suites that have a rate, about the event that is asked for first.
std::vector<ReportedSuite> suites_with_rate(const FragilityReport& report) {
  std::vector<ReportedSuite> suites;
  for (const auto& curve : report.curves) {
    const auto* suite = std::get_if<ReportedSuite>(&curve);
    if (suite == nullptr || !suite->rate) continue;
    const bool is_of_first = suites.empty() || suite->curve.subject.event == suites.front().curve.subject.event;
    if (is_of_first) suites.push_back(*suite);
  }
  return suites;
}

std::vector<ReportedComparison> comparisons_of(const FragilityReport& report, const ResponseEvent& event) {
  std::vector<ReportedComparison> comparisons;
  for (const ReportedComparison& each : report.comparisons) {
    if (each.comparison.event == event) comparisons.push_back(each);
  }
  return comparisons;
}

/// Its curves, without titles, and without what all legends say.
analysis::Figure curves_of(const FragilityReport& report, const ResponseEvent& event) {
  analysis::Figure figure = analysis::fragility_figure(report);
  figure.title = figure.subtitle = "";
  const std::string of_all = (event.is_overturning() ? "" : ", " + analysis::event_in_words(event)) + ", all records";
  for (analysis::Panel& panel : figure.panels) {
    panel.y.quantity = "probability";
    for (analysis::Layer& layer : panel.layers)
      layer.legend.resize(std::min(layer.legend.size(), layer.legend.find(of_all)));
  }
  return figure;
}

}  // namespace

Written write_sheet(const StoredRun& stored, const RunFragility& found, const HazardCurve& hazard,
                    const std::filesystem::path& file, const SheetNotes& notes, const Execution& execution) {
  const base::StopRequest stop = execution.stop;
  const FragilityReport report = fragility_report({found});
  std::vector<ReportedSuite> suites = suites_with_rate(report);
  if (suites.empty()) refuse("sheet", "", "needs a suite of ground motions and a hazard curve");
  std::vector<ReportedComparison> comparisons = comparisons_of(report, suites.front().curve.subject.event);
  FragilityReport about;
  about.curves.assign(suites.begin(), suites.end());
  about.comparisons = comparisons;
  const Report run = report_of(stored.experiment, complete_result(stored.experiment, stored.run), {});
  Written written;
  const auto note = [&written](const analysis::Drawing& drawing) {
    if (!drawing.is_drawn()) written.not_drawn.push_back(drawing.reason);
  };
  analysis::Drawing drawing;
  analysis::FigureLook look = analysis::journal_look(analysis::JournalWidth::single_column);
  look.axes_heights.fill(115.0);
  std::string picture =
      analysis::picture_of(curves_of(about, suites.front().curve.subject.event), "png", drawing, stop, look);
  note(drawing);
  std::string text = analysis::sheet_text({.run = run,
                                           .suites = std::move(suites),
                                           .comparisons = std::move(comparisons),
                                           .hazard = hazard,
                                           .periods = measure_periods(stored.experiment),
                                           .survival = found.survival,
                                           .headline = headline(about),
                                           .curve_png = std::move(picture),
                                           .program = base::code_identity(),
                                           .notes = notes});
  if (file.extension() == ".pdf") {
    text = analysis::pdf_of(text, drawing, stop);
    note(drawing);
    if (!drawing.is_drawn()) return written;
  }
  write_atomically(file, text);
  written.files.push_back(file);
  return written;
}

}  // namespace rocking
