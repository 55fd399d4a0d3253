#include "rocking/studies/fragility/study.hpp"

#include <limits>
#include <set>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/studies/fragility/figure.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

/// The format of the exported file, by its name or the ending of the file.
ExportFormat export_format(const RunsQuestion& question) {
  const std::string ending = std::filesystem::path(*question.export_file).extension().string();
  const std::string name = question.export_as ? *question.export_as
                           : ending == ".xml" ? "nrml"
                                              : ending.substr(ending.empty() ? 0 : 1);
  const auto* const found = std::ranges::find(export_format_names, name);
  if (found != export_format_names.end()) return static_cast<ExportFormat>(found - export_format_names.begin());
  throw UnfitQuestion("export", *question.export_file, "must end with .xml or .csv",
                      "or give `export_as`: nrml, pelicun or csv");
}

/// What flags cannot say of each other.
void expect_sensible(const Subject& subject, const RunsQuestion& question) {
  if (question.hazards.size() > 1 && !question.survived) {
    throw UnfitQuestion("hazard", "", "several hazard curves are branches of `survived`", "give one, or add it");
  }
  if (question.export_file) static_cast<void>(export_format(question));
  const std::vector<std::string>& measures = question.question.surface;
  if (!measures.empty() && (measures.size() != 2 || measures[0] == measures[1])) {
    throw UnfitQuestion("surface", "", "must be two different measures");
  }
  if (!question.sheet) return;
  if (subject.runs.size() > 1) throw UnfitQuestion("sheet", "", "is about one run", "name one folder");
  const std::string ending = std::filesystem::path(*question.sheet).extension().string();
  if (ending != ".pdf" && ending != ".html") {
    throw UnfitQuestion("sheet", *question.sheet, "must end with .pdf or .html");
  }
}

void check(const Subject& subject, RunsQuestion& question) {
  expect_sensible(subject, question);
  const std::vector<double>& years = question.question.years;
  question.branches.clear();
  for (const std::string& file : question.hazards) {
    question.branches.push_back(read_hazard(subject.files(file, most_hazard_bytes), file,
                                            {.years = years.size() == 1 ? std::optional(years[0]) : std::nullopt,
                                             .are_years_spare = true,
                                             .measure = question.imt,
                                             .site = hazard_site(question.site),
                                             .statistic = question.statistic}));
  }
  if (!question.branches.empty()) question.question.hazard = question.branches.front();
  if (const auto& file = question.joint_hazard) {
    question.question.joint_hazard =
        read_joint_hazard(subject.files(*file, most_hazard_bytes), *file, question.question.surface);
  }
}

/// The question about a run, with the rare estimates of its curves.
FragilityQuestion question_about(const Experiment& experiment, const RunsQuestion& asked, const FileSource& files) {
  FragilityQuestion question = asked.question;
  if (!asked.rare) return question;
  const std::filesystem::path rare = *asked.rare;
  const std::string file = (std::filesystem::is_directory(rare) ? rare / "rare.json" : rare).string();
  question.rare = rare_levels(files(file, std::numeric_limits<std::size_t>::max()), file, experiment);
  return question;
}

RunFragility curves_of(const NamedRun& run, const RunsQuestion& asked, const FileSource& files,
                       const Execution& execution) {
  const Experiment& experiment = run.stored.experiment;
  const FragilityQuestion question = question_about(experiment, asked, files);
  try {
    return fragility(experiment, run.stored.run, question, execution);
  } catch (const base::InputError& error) {
    const base::Problem& problem = error.problems().front();
    const bool is_of_question = problem.place.starts_with('/') || problem.place == "events";
    if (!is_of_question) throw;                                     // of the hazard curve
    throw UnfitQuestion(run.folder, "", base::to_string(problem));  // the run answers another question
  }
}

/// The curves of the event that is asked for first, as the blocks that have survived.
std::vector<BlockCurve> blocks_of(const RunFragility& found, const std::string& run,
                                  const std::vector<StripeGroup>& groups) {
  std::vector<BlockCurve> blocks;
  const auto add = [&](const auto& shown) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const auto& curve = shown[i * (shown.size() / groups.size())].curve;
      const std::string values = values_of(groups[i].others);
      blocks.push_back(
          {.name = run + (run.empty() || values.empty() ? "" : ", ") + values, .curve = &curve, .group = &groups[i]});
    }
  };
  if (!found.suites.empty()) add(found.suites);
  if (!found.curves.empty()) add(found.curves);
  return blocks;
}

/// Of the blocks of all runs together.
Survival survival_of(const Subject& subject, const RunsQuestion& question, const std::vector<RunFragility>& found,
                     const Execution& execution) {
  std::vector<std::vector<StripeGroup>> groups;
  std::vector<BlockCurve> blocks;
  for (const NamedRun& run : subject.runs) {
    for (const HazardCurve& hazard : question.branches) check_hazard(hazard, run.stored.experiment);
    groups.push_back(stripes_of(run.stored.experiment, store_of(run.stored.run), execution.threads));
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string run = subject.runs.size() > 1 ? subject.runs[i].folder : "";
    const std::vector<BlockCurve> of_run = blocks_of(found[i], run, groups[i]);
    blocks.insert(blocks.end(), of_run.begin(), of_run.end());
  }
  if (blocks.size() > 1 && question.rare) {
    throw UnfitQuestion("survived", "", "takes rare estimates of one block, not of several", "omit `rare_file`");
  }
  const OptionsOfExecution options(execution);
  return survival(blocks, *question.survived, question.branches, subject.runs.front().stored.experiment.seed,
                  {.threads = options.options().threads, .stop = options.options().stop_requested});
}

/// A command for a run that its suites need more levels of; empty: none is needed.
std::string suggestions(const RunFragility& found, const std::string& folder) {
  if (found.suites.empty()) throw UnfitQuestion("suggest", "", folder + " has no suite of ground motions");
  std::set<double> levels;
  std::set<double> rare;  // sampling would not see the event
  for (const ShownSuite& suite : found.suites) {
    const double least = suite.rate->chosen.rare_below.value_or(0.0);
    for (const double level : suite.rate->add_levels) (level < least ? rare : levels).insert(level);
  }
  std::string text;
  if (!rare.empty()) text += "# levels for `rocking rare`: " + levels_in_words({rare.begin(), rare.end()}) + '\n';
  if (levels.empty()) return text;
  return text + "rocking resume " + shell_word(folder) + " --levels " +
         levels_in_words({levels.begin(), levels.end()}) + '\n';
}

std::string suggestions(const Subject& subject, const std::vector<RunFragility>& found) {
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i) text += suggestions(found[i], subject.runs[i].folder);
  return text.empty() ? "the levels suffice: they leave at most 5 % of the rate undecided, and its estimates agree\n"
                      : text;
}

/// How the hazard curve and the ground motions were read.
std::string as_read(const Subject& subject, const RunsQuestion& question) {
  std::string text;
  if (question.question.hazard) text += "hazard: " + hazard_in_words(*question.question.hazard) + '\n';
  for (const NamedRun& run : subject.runs) {
    const std::string of_run = ground_motion_text(run.stored.experiment);
    if (text.find(of_run) == std::string::npos) text += of_run;
    if (question.question.hazard && intensity_of(run.stored.experiment) == level_pointer) {
      text += has_return_periods(run.stored.experiment)
                  ? "levels: the return periods of the table, at which the hazard curve gives " +
                        question.question.hazard->intensity + '\n'
                  : "levels: those of the table are taken to be in " + question.question.hazard->intensity +
                        ", as the hazard curve is\n";
    }
  }
  return text;
}

std::vector<analysis::Figure> figures_of(const FragilityReport& report) {
  std::vector<analysis::Figure> figures{analysis::fragility_figure(report)};
  if (auto figure = analysis::surface_figure(report)) figures.push_back(std::move(*figure));
  if (auto figure = analysis::incremental_figure(report.incremental)) figures.push_back(std::move(*figure));
  return figures;
}

/// Writes the sheet of the only run.
More sheet_of(const NamedRun& run, const RunsQuestion& question, const RunFragility& found,
              const Execution& execution) {
  const SheetNotes notes{
      .command = "rocking fragility " + shell_word(run.folder) + flags_of(fields_of(&question), &question),
      .project = question.project.value_or(""),
      .date = question.date.value_or("")};
  Written sheet = write_sheet(run.stored, found, *question.question.hazard, *question.sheet, notes, execution);
  const bool is_written = !sheet.files.empty();
  return {.lines = is_written ? "sheet: " + *question.sheet + '\n' : "",
          .is_complete = is_written,
          .notices = std::move(sheet.not_drawn)};
}

Answer find(const Subject& subject, const RunsQuestion& question, const Circumstances& circumstances) {
  std::vector<RunFragility> found;
  for (const NamedRun& run : subject.runs) {
    found.push_back(curves_of(run, question, subject.files, circumstances.execution));
    found.back().name = run.folder;
  }
  if (question.survived) found.front().survival = survival_of(subject, question, found, circumstances.execution);
  const FragilityReport report = fragility_report(found);
  Answer answer{.document = fragility_document().text(report)};
  if (question.suggest) {
    answer.table = suggestions(subject, found);
    answer.is_alone = true;
  } else {
    const RecordTable records = question.per_record ? RecordTable::shown : RecordTable::omitted;
    answer.table = (report.survival ? survival_table(*report.survival) + '\n' : "") +
                   fragility_table(report, records, circumstances.extent) + as_read(subject, question);
  }
  if (circumstances.draws) answer.figures = figures_of(report);
  ExportedFragility out;
  if (question.export_file) out = exported(found, export_format(question));
  if (question.sheet || question.export_file) {
    answer.write_more = [&run = subject.runs.front(), question, of_run = found.front(),
                         out](const Execution& execution) {
      More more = question.sheet ? sheet_of(run, question, of_run, execution) : More{};
      if (!question.export_file) return more;
      write_atomically(*question.export_file, out.text);
      more.lines += "export: " + *question.export_file + '\n';
      more.notices.insert(more.notices.end(), out.notices.begin(), out.notices.end());
      return more;
    };
  }
  return answer;
}

std::vector<StudyTable> tables(const Json& document) { return fragility_tables(fragility_document().read(document)); }

std::string document_of_run(const RunShown& run) {
  if (intensity_of(run.experiment).empty() || run.experiment.conditions.front().until) return {};
  RunOptions options;
  options.threads = run.threads;
  const RunFragility found = run_fragility(run.experiment, stripes_of(run.experiment, run.store, run.threads),
                                           {.hazard = run.hazard, .incremental = true}, options);
  return found.suites.empty() ? "" : fragility_document().text(fragility_report({found}));
}

constexpr StudyFunctions<RunsQuestion> functions{.check = check,
                                                 .find = find,
                                                 .figures = figures_in<fragility_document, figures_of>,
                                                 .tables = tables,
                                                 .document_of_run = document_of_run};

}  // namespace

const Study& fragility_study() {
  static const Study study = study_of<RunsQuestion, functions>({
      .name = "fragility",
      .sentence = "Fit the probability of overturning, or of another event, as a function of intensity",
      .example = "out -o out",
      .text = "counts for each amplitude (or scale of a ground motion) the realisations that overturned, with exact "
              "intervals, and fits a lognormal fragility function with its band. A grid has one curve for each "
              "combination of values of the other entries; the curves of several runs are shown together. A suite of "
              "ground motions has a pooled curve with the scatter between and within records, and one curve for each "
              "record. `-o` saves the numbers in out/fragility.json, which `rocking report` draws.",
      .python_notes = "Raises InputError if the experiment sweeps no intensity of the excitation or its number of "
                      "realisations is not fixed.",
      .python_example = R"(>>> import rocking
>>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
...     "horizon": {"transient_periods": 5, "sampled_periods": 15}, "realisations": 10, "seed": "0x1",
...     "sweep": [{"parameter": "/excitation/amplitude", "values": [1.0, 4.0, 12.0]}]}
>>> rocking.fragility(slab).curves[0].levels.column("intensity")
array([ 1.,  4., 12.]))",
      .subject = SubjectKind::runs,
      .has_long_table = true,
      .draws = true,
      .progress = "parts of the fit",
      .file = "fragility.json",
      .document = fragility_document(),
  });
  return study;
}

}  // namespace rocking
