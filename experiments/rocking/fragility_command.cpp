#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/fragility_figure.hpp"
#include "analysis/incremental_figure.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "drawing.hpp"
#include "machine.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/annual_rate_table.hpp"
#include "rocking/output/fragility_report.hpp"
#include "rocking/output/fragility_table.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct FragilityCommand {
  std::vector<std::string> folders;
  FragilityQuestion question;
  std::string hazard;  ///< file of a hazard curve; empty: none
  StudyFile file{"fragility.json"};
  std::string figures;  ///< folder; empty: nothing is drawn
  bool per_record = false;
  bool suggests = false;
  StyleRequest style;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

RunFragility fragility_of(const std::string& folder, const FragilityQuestion& question,
                          const ExecutionOptions& execution) {
  RunFolder(folder).expect_installed();
  const StoredRun stored = input_of([&] { return open_run(folder); });
  if (stored.run.done < stored.run.all || !stored.run.is_complete()) {
    throw MissingInput(fmt::format(
        "{0}: has {1} of {2} realisations; `rocking resume {0}`, or `rocking merge` of all parts, completes it", folder,
        stored.run.done, stored.run.all));
  }
  Progress progress(suitable_progress_style(execution.loudness), "parts of the fit");
  try {
    return rocking::fragility(stored.experiment, stored.run, question, watched(execution, progress));
  } catch (const base::InputError& error) {
    const base::Problem& problem = error.problems().front();
    if (!problem.place.starts_with('/')) throw;                           // of the hazard curve
    throw UsageError(fmt::format("{}: {}", folder, to_string(problem)));  // the run answers another question
  }
}

WrittenFigures draw_fragility(const FragilityReport& report, const std::string& folder,
                              const analysis::FigureLook& look) {
  std::vector<analysis::Figure> figures{analysis::fragility_figure(report)};
  if (auto figure = analysis::incremental_figure(report)) figures.push_back(std::move(*figure));
  return write_figures(figures, folder, look);
}

/// A line for each suite that has something to add, or one that says so.
std::string suggestions(const FragilityReport& report, const std::vector<std::string>& folders) {
  std::string text;
  for (const auto& curve : report.curves) {
    const auto* suite = std::get_if<ReportedSuite>(&curve);
    if (suite == nullptr || !suite->rate || suite->rate->add_levels.empty()) continue;
    const std::string folder = folders.size() == 1 ? folders.front() : "DIR";
    text += fmt::format("rocking resume {} --levels {}\n", folder, levels_in_words(suite->rate->add_levels));
  }
  return text.empty() ? "the levels suffice: they leave at most 5 % of the rate undecided, and its estimates agree\n"
                      : text;
}

ExitCode fragility(const FragilityCommand& command) {
  const analysis::FigureLook look = look_for(command.style);
  if (command.suggests && command.hazard.empty()) {
    throw UsageError("--suggest: needs a rate; add --hazard FILE");
  }
  if (command.file.is_asked()) command.file.expect_free();
  FragilityQuestion question = command.question;
  if (!command.hazard.empty()) question.hazard = input_of([&] { return hazard_curve(command.hazard); });
  std::vector<RunFragility> runs;
  for (const std::string& folder : command.folders) runs.push_back(fragility_of(folder, question, command.execution));
  const FragilityReport report = fragility_report(runs);
  const std::string text = fragility_document().text(report);
  std::string table = fragility_table(report, command.per_record ? RecordTable::shown : RecordTable::omitted);
  command.file.prepare();
  table += command.file.write(text);
  WrittenFigures written;
  if (!command.figures.empty()) {
    written = draw_fragility(report, command.figures, look);
    table += fmt::format("{}\n", fmt::join(written.files, "\n"));
  }
  if (command.suggests) table = suggestions(report, command.folders);
  print_study(command.execution.loudness, text, table);
  return written.failures.tell(no_figure, PictureRole::purpose);
}

}  // namespace

void add_fragility(CLI::App& app, Action& action) {
  const auto request = std::make_shared<FragilityCommand>();
  CLI::App* command = app.add_subcommand("fragility", "Fit the probability of overturning as a function of intensity");
  command->footer(
      "Example: rocking fragility out -o out\n"
      "counts for each amplitude (or scale of a ground motion) the realisations that overturned, with exact intervals, "
      "and fits a lognormal fragility function with its band. A grid has one curve for each combination of values of "
      "the other entries; the curves of several runs are shown together. A suite of ground motions has a pooled curve "
      "with the scatter between and within records, and one curve for each record. `-o` saves the numbers in "
      "out/fragility.json, which `rocking figure` draws.");
  command->add_option("DIR", request->folders, "Folders of finished runs")->required();
  command
      ->add_option("--peak-tilt", request->question.peak_tilts,
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
  command->add_flag("--suggest", request->suggests,
                    "Print only the intensities that would settle the rate of a suite, as a command");
  command->add_flag("--per-record", request->per_record, "List each record of a suite");
  command->add_flag("--ida", request->question.incremental, "Also the peak tilt against intensity for each record");
  request->file.add_to(*command, false);
  command->add_option("--figure", request->figures, "Folder for figures; created if necessary")->type_name("DIR");
  add_style(*command, request->style);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return fragility(*request); }; });
}

}  // namespace rocking::program
