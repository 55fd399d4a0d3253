#include "report_again.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawing.hpp"
#include "interrupt.hpp"
#include "output.hpp"
#include "rocking/api/folder_run.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/output/run_tables.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/files.hpp"

namespace rocking::program {
namespace fs = std::filesystem;

void HazardFile::add_to(CLI::App& command, const std::string& effect) {
  CLI::Option* file = command
                          .add_option("--hazard", file_,
                                      "Hazard curve (CSV: intensity, annual_rate or poe; its header names measure and "
                                      "kind; or of OpenQuake or the USGS): " +
                                          effect)
                          ->type_name("FILE");
  command
      .add_option("--years", reading_.years,
                  "With --hazard: the years of its probabilities of exceedance, where the file does not state them")
      ->type_name("T")
      ->needs(file);
  command
      .add_option("--imt", reading_.measure,
                  "With --hazard: the intensity measure, where the file has several or does not name it, such as PGA "
                  "or SA(0.5)")
      ->type_name("MEASURE")
      ->needs(file);
  command.add_option("--site", site_, "With --hazard: longitude and latitude of the site, where the file has several")
      ->type_name("LON,LAT")
      ->delimiter(',')
      ->needs(file);
  command
      .add_option("--statistic", reading_.statistic,
                  "With --hazard: mean or quantile-0.84, or as the file says it, where it has several")
      ->type_name("NAME")
      ->needs(file);
}

std::optional<HazardCurve> HazardFile::read() const {
  if (!is_given()) return std::nullopt;
  return input_of([this] {
    HazardReading reading = reading_;
    reading.site = hazard_site(site_);
    return hazard_curve(file_, reading);
  });
}

ExitCode report_again(const ReportRequest& request) {
  const analysis::FigureLook look = look_for(request.style);
  const std::string& path = request.paths.front();
  const RunFolder folder(path);
  const Report report = report_in(folder);
  if (request.hazard.is_given() && !sweeps_records(report)) {
    throw UsageError("--hazard: " + path + " has no suite of ground motions");
  }
  const std::optional<HazardCurve> hazard = request.hazard.read();
  const std::set<std::string> formats(request.formats.begin(), request.formats.end());
  std::vector<std::string> written;
  std::vector<analysis::Drawing> of_the_page;
  std::vector<analysis::Drawing> of_figures;
  if (formats.contains("html")) {
    ensure_writable(path);
    of_the_page = write_page(folder, report, hazard);
    written.push_back(folder.page_path().string());
  }
  if (formats.contains("gnuplot")) {
    analysis::WrittenFigures figures = analysis::write_figures(
        figures_of(folder, report, hazard), fs::path(path) / "figures", request.style.pictures, stop_on_signal(), look);
    of_figures = std::move(figures.failures);
    std::move(figures.files.begin(), figures.files.end(), std::back_inserter(written));
  }
  const fs::path tables = fs::path(path) / "tables";
  std::map<std::string, std::string> texts = table_files(report, formats);
  for (TextFile& table : tables_of(folder, report, hazard, formats)) texts[table.name] = std::move(table.text);
  for (const auto& [name, text] : texts) {
    ensure_writable(tables);
    write_atomically(tables / name, text);
    written.push_back((tables / name).string());
  }
  print_written(request.loudness, written, formats.contains("text") ? tables_in_full(report, table_look()) : "");
  const ExitCode page_code = tell(of_the_page, no_page_picture, PictureRole::purpose);
  const ExitCode figure_code = tell(of_figures, no_figure, PictureRole::purpose);
  return figure_code == ExitCode::done ? page_code : figure_code;
}

ExitCode draw_files(const ReportRequest& request) {
  if (request.hazard.is_given()) throw UsageError("--hazard: is for the folder of a run, not with -o DIR");
  if (!(request.window.from < request.window.to)) {
    throw UsageError(fmt::format("--from {:g}: must be less than --to {:g}", request.window.from, request.window.to));
  }
  const analysis::FigureLook look = look_for(request.style);
  std::vector<analysis::OutputFile> files;
  for (const std::string& path : request.paths) {
    files.push_back({.path = path, .text = input_of([&path] { return read_file(path); })});
  }
  const auto figures = analysis::output_figures(files, request.window);
  auto written = analysis::write_figures(figures, request.drawn, request.style.pictures, stop_on_signal(), look);
  for (const TextFile& table : analysis::output_tables(files)) {
    const fs::path path = fs::path(request.drawn) / table.name;
    write_atomically(path, table.text);
    written.files.push_back(path.string());
  }
  print_result(request.loudness.json ? facts_text(std::vector<Fact>{{"written", written.files}})
                                     : base::printable(fmt::format("{}\n", fmt::join(written.files, "\n"))));
  return tell(written.failures, no_figure, PictureRole::purpose);
}

}  // namespace rocking::program
