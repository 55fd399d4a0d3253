#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
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
#include "rocking/api/studies.hpp"
#include "rocking/output/rare_report.hpp"
#include "study_file.hpp"
#include "usage.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

constexpr std::uint64_t least_particles = 20;
constexpr std::uint64_t most_particles = 100'000;

struct RareCommand {
  std::string experiment;
  StudyFile file{"rare.json"};
  RareRequest rare;
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// The estimates in the file of the command; none without a file.
std::vector<RareEstimate> earlier_estimates(const StudyFile& file, const RareReport& asked) {
  std::vector<RareEstimate> found;
  if (!std::filesystem::exists(file.path())) return found;
  file.read_earlier([&](const Json& earlier) { found = estimates_for(asked, rare_document().read(earlier)); });
  return found;
}

ExitCode end_of(const std::vector<ReportedRare>& conditions, const StudyFile& file) {
  const bool is_stopped =
      std::ranges::any_of(conditions, [](const auto& one) { return one.estimate.end == RareEnd::stopped; });
  if (!is_stopped) return ExitCode::done;
  print_notice(fmt::format("interrupted; the finished repetitions are in {}. The same command with --resume goes on",
                           file.path().string()));
  return ExitCode::interrupted;
}

ExitCode rare(RareCommand& command) {
  const ExperimentText source = load_experiment_text(command.experiment);
  const Experiment experiment = load_experiment(source, command.overrides);
  RareRequest request = command.rare;
  request.elapsed_seconds = seconds_from_now();
  check_source(source, [&] { check_request(experiment, request); });
  command.file.prepare();
  const auto report_on = [&](const std::vector<RareEstimate>& found) {
    return rare_report(experiment, {.question = request.question, .particles = request.particles}, found);
  };
  if (command.file.resumes()) request.earlier = earlier_estimates(command.file, report_on({}));
  request.keeps_when_stopped = true;
  request.keep = [&](const std::function<std::vector<RareEstimate>()>& so_far) {
    command.file.keep([&] { return rare_document().text(report_on(so_far())); });
  };
  Progress progress(suitable_progress_style(command.execution.loudness), "realisations");
  const RareReport report = report_on(rare_probabilities(experiment, request, watched(command.execution, progress)));
  const std::string text = rare_document().text(report);
  deliver_study(command.execution.loudness, text, heading(experiment) + rare_table(report),
                [&] { return command.file.write(text); });
  return end_of(report.conditions, command.file);
}

void add_question(CLI::App& command, RareCommand& request) {
  command
      .add_option("--relative-error", request.rare.question.relative_error,
                  "Standard error over the probability that is aimed at")
      ->check(number(1e-3, 1.0))
      ->capture_default_str()
      ->type_name("E");
  command
      .add_option("--peak-tilt", request.rare.question.event.peak_tilt,
                  "Ask for abs(Theta) > A instead of overturning; 1 is the unstable equilibrium")
      ->check(number(0.0, 100.0))
      ->type_name("A");
  add_duration(command, "--max-time,--at-most-work", request.rare.seconds,
               "Stop after this time for all conditions together, e.g. 10min; what is finished then counts");
  command.add_option("--particles", request.rare.particles, "Trajectories of a repetition")
      ->check(whole_number(least_particles, most_particles))
      ->capture_default_str()
      ->type_name("N");
}

}  // namespace

void add_rare(CLI::App& app, Action& action) {
  const auto request = std::make_shared<RareCommand>();
  CLI::App* command = app.add_subcommand("rare", "Estimate the probability of rare overturning");
  command->footer(
      "Example: rocking rare experiments/headline/headline.json -o out --max-time 10min\n"
      "estimates probabilities far below 1 over the number of simulated realisations: by a particle run that prefers "
      "motions from which overturning is likely, or by importance sampling where all numbers are drawn once. Writes "
      "the "
      "probability of each condition with its interval to out/rare.json and prints it. Something must be random.");
  add_experiment(*command, request->experiment);
  request->file.add_to(*command, true);
  request->file.add_resume(*command, "repetitions");
  add_question(*command, *request);
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return program::rare(*request); }; });
}

}  // namespace rocking::program
