#include <cstdint>
#include <memory>
#include <string>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "experiment_argument.hpp"
#include "machine.hpp"
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

ExitCode rare(const RareCommand& command) {
  const ExperimentText source = load_experiment_text(command.experiment);
  const Experiment experiment = load_experiment(source, command.overrides);
  RareRequest request = command.rare;
  request.elapsed_seconds = seconds_from_now();
  check_source(source, [&] { check_request(experiment, request); });
  command.file.prepare();
  Progress progress(suitable_progress_style(command.execution.loudness), "repetitions");
  const RareReport report =
      rare_report(experiment, {.question = request.question, .score = request.score, .particles = request.particles},
                  rare_probabilities(experiment, request, watched(command.execution, progress)));
  const std::string text = rare_document().text(report);
  print_study(command.execution.loudness, text, heading(experiment) + rare_table(report) + command.file.write(text));
  return ExitCode::done;
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
  command.add_option("--particles", request.rare.particles, "Trajectories of a repetition at each level")
      ->check(whole_number(least_particles, most_particles))
      ->capture_default_str()
      ->type_name("N");
  const auto set_score = [&request](const std::string& name) {
    request.rare.score = name == "energy" ? rare::Score::energy : rare::Score::tilt;
  };
  command
      .add_option_function<std::string>("--score", set_score,
                                        "What measures how near a motion is to the event: tilt or energy")
      ->check(one_of({"tilt", "energy"}))
      ->type_name("tilt|energy");
}

}  // namespace

void add_rare(CLI::App& app, Action& action) {
  const auto request = std::make_shared<RareCommand>();
  CLI::App* command =
      app.add_subcommand("rare", "Estimate the probability of rare overturning by multilevel splitting");
  command->footer(
      "Example: rocking rare experiments/headline/headline.json -o out --max-time 10min\n"
      "goes to the event by levels: trajectories that reach a level are continued, with new random numbers, to the "
      "next one. Writes the probability of each condition with its interval to out/rare.json and prints it. Something "
      "must be random.");
  add_experiment(*command, request->experiment);
  request->file.add_to(*command, true);
  add_question(*command, *request);
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return program::rare(*request); }; });
}

}  // namespace rocking::program
