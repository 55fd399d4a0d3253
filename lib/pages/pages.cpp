#include "rocking/pages.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "analysis/draw.hpp"
#include "analysis/look.hpp"
#include "analysis/page/page.hpp"
#include "analysis/run_figures.hpp"
#include "analysis/tables.hpp"
#include "pages/animation.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/api/trajectory_extent.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/output/report.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/fragility/sheet.hpp"
#include "rocking/studies/output_figures.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;

Report report_of(const StoredRun& stored, const Provenance& provenance = {}) {
  if (stored.experiment.canonical_text.empty()) {
    refuse("experiment", "", "was made in C++ and has no text; read it from a file or from text");
  }
  return report_of(stored.experiment, complete_result(stored.experiment, stored.run), facts_of(provenance));
}

std::vector<analysis::Figure> figures_of(const StoredRun& stored, const Report& report) {
  std::vector<analysis::Figure> figures = analysis::run_figures(report, &store_of(stored.run));
  if (!sweeps_records(report)) return figures;
  for (analysis::Figure& figure : figures_of_studies({stored.experiment, store_of(stored.run), 1, std::nullopt})) {
    figures.push_back(std::move(figure));
  }
  return figures;
}

void note(const analysis::Drawing& drawing, Written& written) {
  if (drawing.is_drawn() || std::ranges::find(written.not_drawn, drawing.reason) != written.not_drawn.end()) return;
  written.not_drawn.push_back(drawing.reason);
}

analysis::FigureLook look_for(Column column) {
  switch (column) {
    case Column::journal_single: return analysis::journal_look(analysis::JournalWidth::single_column);
    case Column::journal_double: return analysis::journal_look(analysis::JournalWidth::double_column);
    case Column::screen: break;
  }
  return analysis::screen_look();
}

Written write_all(const std::vector<analysis::Figure>& figures, const fs::path& folder, Column column,
                  const Execution& execution) {
  ensure_writable(folder);
  Written written;
  for (const analysis::Figure& figure : figures) {
    const analysis::Drawing drawing =
        analysis::write_figure(figure, folder, analysis::picture_formats(), execution.stop, look_for(column));
    note(drawing, written);
    for (const std::string& ending : analysis::text_formats())
      written.files.push_back(folder / (figure.name + '.' + ending));
    if (!drawing.is_drawn()) continue;
    for (const std::string& format : analysis::picture_formats()) {
      written.files.push_back(folder / (figure.name + '.' + format));
    }
  }
  return written;
}

}  // namespace

Written write_page(const StoredRun& stored, const fs::path& file, const Provenance& provenance,
                   const Execution& execution) {
  const Report report = report_of(stored, provenance);
  Written written;
  std::vector<analysis::DrawnFigure> drawn;
  for (analysis::Figure& figure : figures_of(stored, report)) {
    analysis::Drawing drawing;
    std::string svg = analysis::picture_of(figure, "svg", drawing, execution.stop);
    note(drawing, written);
    drawn.push_back({.figure = std::move(figure), .svg = std::move(svg)});
  }
  write_atomically(
      file, analysis::page_text(report, drawn, pages::animations_of(stored.experiment, store_of(stored.run), report)));
  written.files.push_back(file);
  return written;
}

Written write_figures(const StoredRun& stored, const fs::path& folder, Column column, const Execution& execution) {
  return write_all(figures_of(stored, report_of(stored)), folder, column, execution);
}

Written write_tables(const StoredRun& stored, const fs::path& folder) {
  const Report report = report_of(stored);
  ensure_writable(folder);
  Written written;
  const auto write = [&](const char* name, const std::string& text) {
    write_atomically(folder / name, text);
    written.files.push_back(folder / name);
  };
  write("modes.csv", analysis::modes_csv(report));
  write("non_recurrence.csv", analysis::non_recurrence_csv(report));
  write("quantiles.csv", analysis::quantiles_csv(report));
  write("modes.tex", analysis::modes_latex(report));
  return written;
}

Written write_sheet(const StoredRun& stored, const RunFragility& found, const HazardCurve& hazard, const fs::path& file,
                    const std::string& command, const Execution& execution) {
  Sheet sheet = write_fragility_sheet(stored, found, hazard, file, command, execution.stop);
  Written written{.files = {}, .not_drawn = std::move(sheet.not_drawn)};
  if (sheet.is_written) written.files.push_back(file);
  return written;
}

void write_trajectory_page(const Experiment& experiment, const TrajectoryRequest& request, const fs::path& file,
                           const Execution& execution) {
  check_request(experiment, request);
  const TrajectoryExtent extent(periods_of(experiment, request), request.samples_per_period, execution.stop);
  const auto text = pages::animation_page_of(experiment, {request.condition, request.realisation}, extent);
  if (!text) {
    refuse("samples_per_period", std::to_string(request.samples_per_period),
           "are too few: the block overturns before two samples were taken");
  }
  write_atomically(file, *text);
}

Written draw(const std::vector<StudyText>& texts, const fs::path& folder, Column column, const Execution& execution) {
  std::vector<analysis::OutputFile> files;
  for (const StudyText& each : texts) files.push_back({.path = each.name, .text = each.text});
  return write_all(analysis::output_figures(files, {}), folder, column, execution);
}

}  // namespace rocking
