#include "rocking/pages.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "analysis/draw.hpp"
#include "analysis/look.hpp"
#include "analysis/run_figures.hpp"
#include "pages/run_page.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/output/run_tables.hpp"
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

std::vector<analysis::Figure> figures_of(const StoredRun& stored, const Report& report, const Execution& execution,
                                         const std::optional<HazardCurve>& hazard) {
  std::vector<analysis::Figure> figures = analysis::run_figures(report, &store_of(stored.run));
  if (!sweeps_records(report) && hazard) refuse("hazard", hazard->name, "needs a run with a suite of ground motions");
  if (!sweeps_records(report)) return figures;
  for (analysis::Figure& figure :
       figures_of_studies({stored.experiment, store_of(stored.run), execution.threads, hazard})) {
    figures.push_back(std::move(figure));
  }
  return figures;
}

Written written_of(std::vector<fs::path> files, const std::vector<analysis::Drawing>& failures) {
  Written written{.files = std::move(files), .not_drawn = {}};
  for (const analysis::Drawing& failure : failures) written.not_drawn.push_back(failure.reason);
  return written;
}

analysis::FigureLook look_for(Column column) {
  switch (column) {
    case Column::journal_single: return analysis::journal_look(analysis::JournalWidth::single_column);
    case Column::journal_double: return analysis::journal_look(analysis::JournalWidth::double_column);
    case Column::screen: break;
  }
  return analysis::screen_look();
}

Written write_all(const std::vector<analysis::Figure>& figures, const fs::path& folder, const Drawn& drawn,
                  const Execution& execution) {
  const std::vector<std::string>& known = analysis::figure_formats();
  for (const std::string& picture : drawn.pictures) {
    if (std::ranges::find(known, picture) == known.end()) {
      refuse("pictures", picture, "is no kind of picture: write svg, png, pdf or gp");
    }
  }
  const analysis::WrittenFigures all =
      analysis::write_figures(figures, folder, drawn.pictures, execution.stop, look_for(drawn.column));
  return written_of({all.files.begin(), all.files.end()}, all.failures);
}

}  // namespace

Written write_page(const StoredRun& stored, const fs::path& file, const Provenance& provenance,
                   const Execution& execution, const std::optional<HazardCurve>& hazard) {
  const Report report = report_of(stored, provenance);
  const auto motions = pages::animations_of(stored.experiment, store_of(stored.run), report);
  return written_of(
      {file}, pages::write_page(file, report, figures_of(stored, report, execution, hazard), motions, execution.stop));
}

Written write_figures(const StoredRun& stored, const fs::path& folder, const Drawn& drawn, const Execution& execution,
                      const std::optional<HazardCurve>& hazard) {
  return write_all(figures_of(stored, report_of(stored), execution, hazard), folder, drawn, execution);
}

Written write_tables(const StoredRun& stored, const fs::path& folder) {
  const Report report = report_of(stored);
  ensure_writable(folder);
  Written written;
  for (const auto& [name, text] : table_files(report, {"csv", "latex"})) {
    write_atomically(folder / name, text);
    written.files.push_back(folder / name);
  }
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

Written draw(const std::vector<StudyText>& texts, const fs::path& folder, const Drawn& drawn,
             const Execution& execution, const ShownPeriods& shown) {
  analysis::Window window{.from = shown.from};
  if (shown.to) window.to = *shown.to;
  if (!(window.from < window.to)) refuse("from", base::shortest(window.from), "must be less than the end");
  std::vector<analysis::OutputFile> files;
  for (const StudyText& each : texts) files.push_back({.path = each.name, .text = each.text});
  return write_all(analysis::output_figures(files, window), folder, drawn, execution);
}

}  // namespace rocking
