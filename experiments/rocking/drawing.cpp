#include "drawing.hpp"

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/draw.hpp"
#include "analysis/run_figures.hpp"
#include "arguments.hpp"
#include "exit_code.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "pages/run_page.hpp"
#include "rocking/base/error.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

/// Calls `use` with the run of a suite. Without the records the other figures and tables are written.
template <class Use>
void for_suite(const Store& store, const std::optional<HazardCurve>& hazard, const Use& use) {
  const auto tell = [](const std::exception& error) {
    print_notice(fmt::format("the fragility of the suite was not drawn: {}", error.what()));
  };
  try {
    use(RunShown{experiment_of(store.identity()), store, available_threads(), hazard});
  } catch (const base::InputError& error) {
    if (hazard && error.problems().front().place.starts_with(hazard->name)) throw;
    tell(error);
  } catch (const base::FolderError& error) {
    tell(error);
  }
}

/// Those of the file of a study beside the report, if there is one about the same experiment.
void add_study(const Study& study, const std::filesystem::path& path, const Report& report,
               std::vector<analysis::Figure>& figures) {
  if (!std::filesystem::exists(path)) return;
  const std::string text = input_of([&] { return read_file(path); });
  try {
    const Json document = parse_json(text);
    std::vector<analysis::Figure> drawn = study.figures(document, {});
    if (document.at("input").at("sha256") != report.input.sha256) {
      print_notice(path.string() + ": is about another experiment than the run, and is not drawn");
      return;
    }
    for (analysis::Figure& figure : drawn) figures.push_back(std::move(figure));
  } catch (const base::InputError& error) {
    throw located(error, text, path.string());
  }
}

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

std::vector<analysis::Figure> figures_of(const RunFolder& folder, const Report& report,
                                         const std::optional<HazardCurve>& hazard) {
  std::vector<analysis::Figure> figures;
  if (folder.has_store()) {
    const Store store = folder.open_valid_store();
    figures = analysis::run_figures(report, &store);
    if (sweeps_records(report)) {
      for_suite(store, hazard, [&figures](const RunShown& run) {
        for (analysis::Figure& figure : figures_of_studies(run)) figures.push_back(std::move(figure));
      });
    }
  } else {
    figures = analysis::run_figures(report);
  }
  const std::filesystem::path path = folder.name();
  for (const Study* study : studies()) {
    if (study->is_shown_with_run) add_study(*study, path / study->file, report, figures);
  }
  return figures;
}

std::vector<TextFile> tables_of(const RunFolder& folder, const Report& report, const std::optional<HazardCurve>& hazard,
                                const std::set<std::string>& formats) {
  const bool has_tables = formats.contains("csv") || formats.contains("latex");
  if (!has_tables || !sweeps_records(report) || !folder.has_store()) return {};
  const Store store = folder.open_valid_store();
  std::vector<TextFile> tables;
  for_suite(store, hazard, [&](const RunShown& run) { tables = tables_of_studies(run, formats); });
  return tables;
}

ExitCode tell(const std::vector<analysis::Drawing>& failures, std::string_view consequence, PictureRole role) {
  ExitCode code = ExitCode::done;
  for (const analysis::Drawing& failure : failures) {
    print_notice(fmt::format("{}: {}", consequence, failure.reason));
    if (failure.end == analysis::DrawingEnd::refused) {
      print_notice("this is a bug of this program; please report it with the output of `rocking doctor`");
      code = ExitCode::our_bug;
    }
    const bool fails = failure.end == analysis::DrawingEnd::broken_off && role == PictureRole::purpose;
    if (fails && code == ExitCode::done) code = ExitCode::input_output;
  }
  return code;
}

void add_style(CLI::App& command, StyleRequest& request) {
  command
      .add_option("--style", request.style,
                  "For what figures are drawn; for a journal without titles, with text of 8 pt")
      ->check(CLI::IsMember({"screen", "journal"}))
      ->capture_default_str()
      ->type_name("STYLE");
  command.add_option("--width", request.width, "With --style journal: width of the column, 84 mm (default) or 174 mm")
      ->check(CLI::IsMember({"single", "double"}))
      ->type_name("COLUMN");
  command
      .add_option("--pictures", request.pictures,
                  "In what each figure is written beside its numbers (tsv), separated by commas; gp is gnuplot's "
                  "script. Default: svg, or pdf for a journal")
      ->delimiter(',')
      ->check(one_of(analysis::figure_formats()))
      ->type_name("LIST");
}

analysis::FigureLook look_for(const StyleRequest& request) {
  if (request.style == "journal") {
    return analysis::journal_look(request.width == "double" ? analysis::JournalWidth::double_column
                                                            : analysis::JournalWidth::single_column);
  }
  if (!request.width.empty()) {
    throw UsageError(
        fmt::format("--width {}: only figures for a journal have this width; add --style journal", request.width));
  }
  return analysis::screen_look();
}

std::vector<analysis::Drawing> write_page(const RunFolder& folder, const Report& report,
                                          const std::optional<HazardCurve>& hazard) {
  return pages::write_page(folder.page_path(), report, figures_of(folder, report, hazard),
                           animations_of(folder, report), stop_on_signal());
}

}  // namespace rocking::program
