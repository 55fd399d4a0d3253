#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/fragility_figure.hpp"
#include "analysis/incremental_figure.hpp"
#include "commands.hpp"
#include "drawing.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/output/fragility_table.hpp"
#include "rocking/studies/fragility.hpp"
#include "rocking/studies/run_fragility.hpp"
#include "rocking/text/files.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct FragilityRequest {
  std::vector<std::string> folders;
  std::vector<double> peak_tilts;
  std::string hazard;   ///< file of a hazard curve; empty: none
  std::string output;   ///< empty: nothing is written
  std::string figures;  ///< folder; empty: nothing is drawn
  bool overwrite = false;
  bool per_record = false;
  bool incremental = false;
  StyleRequest style;
  Loudness loudness;
};

void check_run(const Experiment& experiment, const std::string& name) {
  if (intensity_of(experiment).empty()) {
    throw UsageError(name +
                     ": sweeps no intensity of the excitation; give a run whose sweep has /excitation/amplitude (or "
                     "amplitude_g, amplitude_m_s2), or /excitation/scale (or pga_g, pgv_m_s)");
  }
  if (experiment.conditions.front().until) {
    throw UsageError(
        name +
        ": its number of realisations was determined by `until`, which a fragility function does not allow; give a "
        "run with a fixed number of realisations");
  }
}

std::optional<HazardCurve> hazard_of(const FragilityRequest& request) {
  if (request.hazard.empty()) return std::nullopt;
  try {
    return read_hazard(read_file(request.hazard, most_hazard_bytes), request.hazard);
  } catch (const std::system_error& error) {
    throw MissingInput(error.what());
  }
}

RunFragility fragility_of(const std::string& name, const FragilityQuestion& question, const Loudness& loudness) {
  const RunFolder folder(name);
  const Store store = folder.open_valid_store();
  const Experiment experiment = experiment_of(store.identity());
  check_run(experiment, name);
  std::vector<StripeGroup> groups;
  try {
    groups = stripes_of(experiment, store);
  } catch (const base::InputError& error) {
    throw MissingInput(fmt::format("{}: {}", name, error.what()));
  }
  Progress progress(suitable_progress_style(loudness), "parts of the fit");
  RunOptions options;
  options.threads = available_threads();
  options.stop_requested = &stop_on_interrupt();
  options.on_progress = [&](std::uint64_t done, std::uint64_t all) { progress.show(done, all); };
  return run_fragility(experiment, groups, question, options);
}

std::filesystem::path curve_file_in(const std::string& folder) {
  return std::filesystem::path(folder) / "fragility.json";
}

WrittenFigures draw_fragility(const FragilityReport& report, const std::string& folder,
                              const analysis::FigureLook& look) {
  std::vector<analysis::Figure> figures{analysis::fragility_figure(report)};
  if (auto figure = analysis::incremental_figure(report)) figures.push_back(std::move(*figure));
  return write_figures(figures, folder, look);
}

ExitCode fragility(const FragilityRequest& request) {
  const analysis::FigureLook look = look_for(request.style);
  if (!request.output.empty()) expect_free(curve_file_in(request.output), request.overwrite);
  const FragilityQuestion question{
      .peak_tilts = request.peak_tilts, .hazard = hazard_of(request), .incremental = request.incremental};
  std::vector<RunFragility> runs;
  try {
    for (const std::string& name : request.folders) runs.push_back(fragility_of(name, question, request.loudness));
  } catch (const base::Stopped&) {
    print_notice("interrupted; nothing was written");
    return ExitCode::interrupted;
  }
  const FragilityReport report = fragility_report(runs);
  const std::string text = fragility_document().text(report);
  std::string table = fragility_table(report, request.per_record ? RecordTable::shown : RecordTable::omitted);
  if (!request.output.empty()) {
    ensure_writable(request.output);
    write_atomically(curve_file_in(request.output), text);
    table += fmt::format("numbers: {}\n", curve_file_in(request.output).string());
  }
  WrittenFigures written;
  if (!request.figures.empty()) {
    written = draw_fragility(report, request.figures, look);
    table += fmt::format("{}\n", fmt::join(written.files, "\n"));
  }
  print_result(request.loudness.json ? text : base::printable(table));
  return written.failures.tell(no_figure, PictureRole::purpose);
}

}  // namespace

void add_fragility(CLI::App& app, Action& action) {
  const auto request = std::make_shared<FragilityRequest>();
  CLI::App* command = app.add_subcommand("fragility", "Fit the probability of overturning as a function of intensity");
  command->footer(
      "Example: rocking fragility out -o out\n"
      "counts for each amplitude (or scale of a ground motion) the realisations that overturned, with exact intervals, "
      "and fits\n"
      "a lognormal fragility function with its band. A grid has one curve for each combination of values of the other "
      "entries;\n"
      "the curves of several runs are shown together. A suite of ground motions has a pooled curve with the scatter "
      "between and\n"
      "within records, and one curve for each record. `-o` saves the numbers in out/fragility.json, which `rocking "
      "figure`\n"
      "draws.");
  command->add_option("DIR", request->folders, "Folders of finished runs")->required();
  command
      ->add_option("--peak-tilt", request->peak_tilts,
                   "Also the probability that the peak of abs(theta)/psi exceeds A; several: 0.3,0.5,1")
      ->type_name("A")
      ->delimiter(',')
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(CLI::Validator(CLI::Range(1e-9, 1e9)).description(""));
  command
      ->add_option("--hazard", request->hazard,
                   "Hazard curve (CSV: intensity, annual rate of exceedance; its header names the measure): gives the "
                   "mean annual "
                   "rate")
      ->type_name("FILE");
  command->add_flag("--per-record", request->per_record, "List each record of a suite");
  command->add_flag("--ida", request->incremental, "Also the peak tilt against intensity for each record");
  command->add_option("-o,--output", request->output, "Folder for fragility.json; created if necessary")
      ->type_name("DIR");
  command->add_flag("--overwrite", request->overwrite, "Replace fragility.json in the folder");
  command->add_option("--figure", request->figures, "Folder for figures; created if necessary")->type_name("DIR");
  add_style(*command, request->style);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return fragility(*request); }; });
}

}  // namespace rocking::program
