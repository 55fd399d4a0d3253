#include <chrono>
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
#include "machine.hpp"
#include "output.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/rare_report.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "usage.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

constexpr std::uint64_t least_particles = 20;
constexpr std::uint64_t most_particles = 100'000;

struct RareCommand {
  std::string file;
  std::string folder;
  RareRequest rare;
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
  bool overwrite = false;
};

std::function<double()> seconds_from_now() {
  return [start = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
}

/// Throws InputError, with the file and the line, where nothing is random.
void refuse_certainty(const Experiment& experiment, const RareRequest& request, const std::string& file) {
  try {
    check_request(experiment, request);
  } catch (const base::InputError& error) {
    throw located(error, read_file(file), file);
  }
}

std::vector<RareEstimate> estimate(const Experiment& experiment, const RareRequest& request,
                                   const ExecutionOptions& execution) {
  Progress progress(suitable_progress_style(execution.loudness), "repetitions");
  return rare_probabilities(experiment, request, watched(execution, progress));
}

ExitCode find_rare(const RareCommand& command) {
  const Experiment experiment = load_experiment(command.file, command.overrides);
  RareRequest request = command.rare;
  request.elapsed_seconds = seconds_from_now();
  refuse_certainty(experiment, request, command.file);  // before any file is written
  const std::filesystem::path file = std::filesystem::path(command.folder) / "rare.json";
  expect_free(file, command.overwrite);
  ensure_writable(command.folder);
  const RareReport report =
      rare_report(experiment, {.question = request.question, .score = request.score, .particles = request.particles},
                  estimate(experiment, request, command.execution));
  const std::string text = rare_document().text(report);
  expect_free(file, command.overwrite);
  write_atomically(file, text);
  const std::string title = experiment.title.empty() ? "" : experiment.title + "\n\n";
  const std::string where = fmt::format("numbers: {}\n", file.string());
  print_result(command.execution.loudness.json ? text : base::printable(title + rare_table(report) + where));
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
  add_duration(command, "--at-most-work", request.rare.seconds,
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
      "Example: rocking rare experiments/headline/headline.json -o out --at-most-work 10min\n"
      "goes to the event by levels: trajectories that reach a level are continued, with new random numbers, to the "
      "next "
      "one.\n"
      "Writes the probability of each condition with its interval to out/rare.json and prints it. Something must be "
      "random.");
  command->add_option("EXPERIMENT", request->file, "Experiment file (JSON)")->required();
  command->add_option("-o,--output", request->folder, "Folder for the results; created if necessary")
      ->required()
      ->type_name("DIR");
  add_question(*command, *request);
  add_threads(*command, request->execution);
  command
      ->add_option("--seed", request->overrides.seed,
                   "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
  command->add_flag("--overwrite", request->overwrite, "Replace the file of this name in the folder");
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return find_rare(*request); }; });
}

}  // namespace rocking::program
