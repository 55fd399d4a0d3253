#include "report_again.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/tables.hpp"
#include "output.hpp"
#include "page.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

namespace fs = std::filesystem;

Report load_report(const RunFolder& folder) {
  folder.expect_installed();
  if (!folder.has_report()) {
    throw MissingInput(folder.has_store()
                           ? fmt::format("{}: there is no report.json yet; `rocking resume {}` finishes the run",
                                         folder.name(), shell_word(folder.name()))
                           : folder.name() + ": contains no run (there is no report.json)");
  }
  if (folder.has_store()) static_cast<void>(folder.open_store(sqlite::Access::read));  // the report is that of this run
  const std::string text = input_of([&] { return read_file(folder.report_path()); });
  try {
    return parse_report(text);
  } catch (const base::InputError& error) {
    throw located(error, text, folder.report_path().string());
  }
}

/// The table of every condition, however many.
std::string table_again(const Report& report) {
  const std::string settling = settling_text(settling_rows(report), table_look().width);
  return mode_table(table_rows(report), table_look()) + exponent_table(report) +
         (settling.empty() ? "" : '\n' + settling);
}

}  // namespace

ExitCode report_again(const ReportRequest& request) {
  const analysis::FigureLook look = look_for(request.style);
  const RunFolder folder(request.folder);
  const Report report = load_report(folder);
  if (request.hazard.is_given() && !sweeps_records(report)) {
    throw UsageError("--hazard: " + request.folder + " has no suite of ground motions");
  }
  const std::optional<HazardCurve> hazard = request.hazard.read();
  const std::set<std::string> formats(request.formats.begin(), request.formats.end());
  std::vector<std::string> written;
  DrawingFailures of_the_page;
  DrawingFailures of_figures;
  if (formats.contains("html")) {
    ensure_writable(request.folder);
    of_the_page = write_page(folder, report, hazard);
    written.push_back(folder.page_path().string());
  }
  if (formats.contains("gnuplot")) {
    WrittenFigures figures =
        write_figures(figures_of(folder, report, hazard), fs::path(request.folder) / "figures", look);
    of_figures = std::move(figures.failures);
    std::move(figures.files.begin(), figures.files.end(), std::back_inserter(written));
  }
  const fs::path tables = fs::path(request.folder) / "tables";
  for (const auto& [name, text] : analysis::table_files(report, formats)) {
    ensure_writable(tables);
    write_atomically(tables / name, text);
    written.push_back((tables / name).string());
  }
  const std::string table = formats.contains("text") ? table_again(report) : "";
  print_result(request.loudness.json ? facts_text(std::vector<Fact>{{"written", written}})
                                     : base::printable(fmt::format("{}{}{}", table, fmt::join(written, "\n"),
                                                                   written.empty() ? "" : "\n")));
  const ExitCode page_code = of_the_page.tell(no_page_picture, PictureRole::purpose);
  const ExitCode figure_code = of_figures.tell(no_figure, PictureRole::purpose);
  return figure_code == ExitCode::done ? page_code : figure_code;
}

}  // namespace rocking::program
