#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/fragility_figure.hpp"
#include "analysis/incremental_figure.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "drawing.hpp"
#include "exit_code.hpp"
#include "ground_motion_notes.hpp"
#include "hazard_file.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/annual_rate_table.hpp"
#include "rocking/output/fragility_report.hpp"
#include "rocking/output/fragility_table.hpp"
#include "rocking/pages.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct FragilityCommand {
  std::vector<std::string> folders;
  FragilityQuestion question;
  HazardFile hazard;
  std::string rare;      ///< folder of rare.json, or the file; empty: none
  std::string metadata;  ///< file of magnitudes and distances; empty: none
  StudyFile file{"fragility.json"};
  std::string figures;          ///< folder; empty: nothing is drawn
  std::filesystem::path sheet;  ///< empty: none
  bool per_record = false;
  bool suggests = false;
  StyleRequest style;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// A finished run and its curves.
struct Curves {
  StoredRun stored;
  RunFragility found;
};

/// The question about a run, with the rare estimates of its curves.
FragilityQuestion with_rare(FragilityQuestion question, const std::filesystem::path& rare,
                            const Experiment& experiment) {
  if (rare.empty()) return question;
  const std::filesystem::path file = std::filesystem::is_directory(rare) ? rare / "rare.json" : rare;
  question.rare = input_of([&] { return rare_levels(file, experiment); });
  return question;
}

StoredRun finished_run(const std::string& folder) {
  RunFolder(folder).expect_installed();
  StoredRun stored = input_of([&] { return open_run(folder); });
  if (stored.run.done < stored.run.all || !stored.run.is_complete()) {
    throw MissingInput(
        fmt::format("{}: has {} of {} realisations; `rocking resume {}`, or `rocking merge` of all parts, completes it",
                    folder, stored.run.done, stored.run.all, shell_word(folder)));
  }
  return stored;
}

Curves curves_of(StoredRun stored, const std::string& folder, const FragilityCommand& command,
                 const FragilityQuestion& asked) {
  const ExecutionOptions& execution = command.execution;
  const FragilityQuestion question = with_rare(asked, command.rare, stored.experiment);
  Progress progress(suitable_progress_style(execution.loudness), "parts of the fit");
  try {
    RunFragility found = rocking::fragility(stored.experiment, stored.run, question, watched(execution, progress));
    return {std::move(stored), std::move(found)};
  } catch (const base::InputError& error) {
    const base::Problem& problem = error.problems().front();
    if (!problem.place.starts_with('/')) throw;                           // of the hazard curve or the metadata
    throw UsageError(fmt::format("{}: {}", folder, to_string(problem)));  // the run answers another question
  }
}

WrittenFigures draw_fragility(const FragilityReport& report, const std::string& folder,
                              const analysis::FigureLook& look) {
  std::vector<analysis::Figure> figures{analysis::fragility_figure(report)};
  if (auto figure = analysis::incremental_figure(report)) figures.push_back(std::move(*figure));
  return write_figures(figures, folder, look);
}

/// A command for each run that its suites need more levels of, or a line that says that none is needed.
std::string suggestions(const std::vector<Curves>& curves, const std::vector<std::string>& folders) {
  std::string text;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].found.suites.empty())
      throw UsageError("--suggest: " + folders[i] + " has no suite of ground motions");
    std::set<double> levels;
    std::set<double> rare;  // sampling would not see the event
    for (const ShownSuite& suite : curves[i].found.suites) {
      const double least = suite.rate->chosen.rare_below.value_or(0.0);
      for (const double level : suite.rate->add_levels) (level < least ? rare : levels).insert(level);
    }
    if (!rare.empty()) {
      text += fmt::format("# levels for `rocking rare`: {}\n", levels_in_words({rare.begin(), rare.end()}));
    }
    if (levels.empty()) continue;
    text += fmt::format("rocking resume {} --levels {}\n", shell_word(folders[i]),
                        levels_in_words({levels.begin(), levels.end()}));
  }
  return text.empty() ? "the levels suffice: they leave at most 5 % of the rate undecided, and its estimates agree\n"
                      : text;
}

void expect_sensible(const FragilityCommand& command) {
  if (!command.hazard.is_given() && command.suggests) throw UsageError("--suggest: needs a rate; add --hazard FILE");
  if (command.sheet.empty()) return;
  if (!command.hazard.is_given()) throw UsageError("--sheet: needs a rate; add --hazard FILE");
  if (command.folders.size() > 1) throw UsageError("--sheet: is about one run; name one folder");
  const std::string ending = command.sheet.extension().string();
  if (ending != ".pdf" && ending != ".html") {
    throw UsageError(fmt::format("--sheet {}: must end with .pdf or .html", command.sheet.string()));
  }
  command.file.expect_free(command.sheet);
}

/// Writes the sheet, if one is asked for; whether that succeeded.
bool write_sheet(const FragilityCommand& command, const Curves& curves, const FragilityQuestion& question) {
  if (command.sheet.empty()) return true;
  const std::string again = fmt::format("rocking fragility {} {} --sheet {}", shell_word(command.folders.front()),
                                        command.hazard.flags(), shell_word(command.sheet.string()));
  const Written written = rocking::write_sheet(curves.stored, curves.found, *question.hazard, command.sheet, again,
                                               {.stop = &stop_on_interrupt()});
  for (const std::string& reason : written.not_drawn) print_notice(reason);
  return !written.files.empty();
}

ExitCode fragility(FragilityCommand& command) {
  const analysis::FigureLook look = look_for(command.style);
  expect_sensible(command);
  if (command.file.is_asked()) command.file.expect_free();
  FragilityQuestion question = command.question;
  question.hazard = command.hazard.read();
  if (!command.metadata.empty()) question.metadata = input_of([&] { return record_metadata(command.metadata); });
  std::vector<StoredRun> finished;
  for (const std::string& folder : command.folders) finished.push_back(finished_run(folder));
  command.file.prepare();
  std::vector<Curves> curves;
  std::vector<RunFragility> runs;
  for (std::size_t i = 0; i < finished.size(); ++i) {
    curves.push_back(curves_of(std::move(finished[i]), command.folders[i], command, question));
    runs.push_back(curves.back().found);
  }
  const FragilityReport report = fragility_report(runs);
  const std::string text = fragility_document().text(report);
  const RecordTable records = command.per_record ? RecordTable::shown : RecordTable::omitted;
  const std::string table = command.suggests ? suggestions(curves, command.folders)
                                             : fragility_table(report, records, command.execution.extent);
  std::string as_read;
  if (question.hazard) as_read = fmt::format("hazard: {}\n", hazard_in_words(*question.hazard));
  for (const Curves& each : curves) {
    const std::string of_run = ground_motion_text(each.stored.experiment);
    if (as_read.find(of_run) == std::string::npos) as_read += of_run;
  }
  WrittenFigures figures;
  bool has_sheet = false;
  deliver_study(command.execution.loudness, text, table, [&] {
    std::string where = as_read + command.file.write(text);
    if (!command.figures.empty()) {
      figures = draw_fragility(report, command.figures, look);
      where += fmt::format("{}\n", fmt::join(figures.files, "\n"));
    }
    has_sheet = write_sheet(command, curves.front(), question);
    if (!command.sheet.empty() && has_sheet) where += fmt::format("sheet: {}\n", command.sheet.string());
    return command.suggests ? "" : where;
  });
  const ExitCode drawn = figures.failures.tell(no_figure, PictureRole::purpose);
  return has_sheet ? drawn : ExitCode::input_output;
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
  request->hazard.add_to(*command, "gives the mean annual rate");
  command
      ->add_option(
          "--metadata", request->metadata,
          "Magnitudes and distances of the records (CSV: file, magnitude, distance_km): says which measures of "
          "intensity are sufficient")
      ->type_name("FILE");
  command
      ->add_option(
          "--rare", request->rare,
          "Folder with the rare.json of `rocking rare` for lower intensities of the same block and motion, or suite of "
          "motions: the annual rate takes its probabilities below the levels with ten events")
      ->type_name("DIR");
  command->add_flag("--suggest", request->suggests,
                    "Print only the intensities that would settle the rate of a suite, as a command");
  command
      ->add_option("--sheet", request->sheet,
                   "With --hazard: the answer about a suite as one page of A4; FILE ends with .pdf or .html")
      ->type_name("FILE");
  command->add_flag("--per-record", request->per_record, "List each record of a suite");
  command->add_flag("--ida", request->question.incremental, "Also the peak tilt against intensity for each record");
  request->file.add_to(*command, false);
  command->add_option("--figure", request->figures, "Folder for figures; created if necessary")->type_name("DIR");
  add_style(*command, request->style);
  add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return fragility(*request); }; });
}

}  // namespace rocking::program
