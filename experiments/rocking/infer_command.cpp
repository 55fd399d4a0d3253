#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "experiment_argument.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "rocking/api/infer.hpp"
#include "rocking/output/infer_report.hpp"
#include "study_file.hpp"
#include "usage.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct InferCommand {
  std::string experiment;
  std::string tests;
  std::string candidates;  ///< empty: none
  InferRequest infer;
  StudyFile file{"infer.json"};
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

CountedTests load_tests(const InferCommand& command, const Experiment& experiment,
                        const std::filesystem::path& folder) {
  std::optional<std::filesystem::path> candidates;
  if (!command.candidates.empty()) candidates = command.candidates;
  return input_of([&] { return counted_tests(experiment, command.tests, candidates, folder); });
}

/// The design that the file of the command has; none without a file.
std::vector<infer::DesignPoint> earlier_design(const InferCommand& command, const InferReport& asked) {
  if (!std::filesystem::exists(command.file.path())) return {};
  std::vector<infer::DesignPoint> found;
  command.file.read_earlier([&](const Json& earlier) { found = design_for(asked, infer_document().read(earlier)); });
  return found;
}

ExitCode end_of(const Inference& found, const StudyFile& file) {
  if (found.end != InferEnd::stopped) return ExitCode::done;
  print_notice(fmt::format("interrupted; the finished points are in {}. The same command with --resume goes on",
                           file.path().string()));
  return ExitCode::interrupted;
}

ExitCode infer(InferCommand& command) {
  const ExperimentText source = load_experiment_text(command.experiment);
  const Experiment experiment = load_experiment(source, command.overrides);
  check_source(source, [&] { check_infer(experiment); });
  InferRequest request = command.infer;
  request.folder = source.folder;
  check_source(source, [&] { request.tests = load_tests(command, experiment, source.folder); });
  request.elapsed_seconds = seconds_from_now();
  request.keeps_when_stopped = true;
  command.file.prepare();
  const auto report_on = [&](const Inference& found) {
    return infer_report(experiment, request.tests, request.next_tests, found);
  };
  if (command.file.resumes()) request.earlier = earlier_design(command, report_on({}));
  request.keep = [&](const std::vector<infer::DesignPoint>& design) {
    command.file.keep(
        [&] { return infer_document().text(report_on({.design = design, .answer = {}, .end = InferEnd::stopped})); });
  };
  Inference found;
  {
    Progress progress(suitable_progress_style(command.execution.loudness), "realisations and made-up data sets");
    found = infer_unknowns(experiment, request, watched(command.execution, progress));
  }
  const InferReport report = report_on(found);
  const std::string text = infer_document().text(report);
  deliver_study(command.execution.loudness, text, heading(experiment) + infer_table(report),
                [&] { return command.file.write(text); });
  return end_of(found, command.file);
}

}  // namespace

void add_infer(CLI::App& app, Action& action) {
  const auto request = std::make_shared<InferCommand>();
  CLI::App* command = app.add_subcommand("infer", "Infer unknown numbers from counted tests");
  command->footer(
      "Example: rocking infer campaign.json --tests tests.csv -o out\n"
      "answers which values of the unknowns of the experiment (its key `unknown`) make the counted response modes of "
      "tests likely: estimates, intervals, a joint region, and whether the counts fit at all. tests.csv has a line for "
      "each tested condition: parameters by JSON pointer or last key, then a column of counts for each response mode, "
      "such as \"(1,1)\" or other. Writes out/infer.json.");
  add_experiment(*command, request->experiment);
  command->add_option("--tests", request->tests, "Counted tests, CSV: a line for each condition")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--candidates", request->candidates,
                   "Conditions that may be tested next, CSV without counts: how much each would tell")
      ->type_name("FILE");
  command->add_option("--next-tests", request->infer.next_tests, "Tests of a candidate condition")
      ->check(whole_number(1, 1000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--realisations", request->overrides.realisations,
                   "Realisations of each condition at each point, instead of the file's")
      ->type_name("N");
  add_duration(*command, "--max-time", request->infer.seconds,
               "Add no points to the design after this time, e.g. 10min, and answer from those that are finished");
  request->file.add_to(*command, true);
  request->file.add_resume(*command, "points");
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return program::infer(*request); }; });
}

}  // namespace rocking::program
