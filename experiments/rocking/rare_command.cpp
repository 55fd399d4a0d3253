#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "rocking/output/rare_report.hpp"
#include "rocking/studies/rare/rare.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

constexpr std::uint64_t least_particles = 20;
constexpr std::uint64_t most_particles = 100'000;

struct RareRequest {
  std::string file;
  std::string folder;
  RareQuestion question;
  std::uint64_t particles = RareSettings{}.particles;
  rare::Score score = RareSettings{}.score;
  std::optional<double> at_most_work;  ///< [s]
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
  bool overwrite = false;
};

/// Throws InputError, with the file and the line, where nothing is random.
void refuse_certainty(const Experiment& experiment, const std::string& file) {
  try {
    check_rare(experiment);
  } catch (const base::InputError& error) {
    throw located(error, read_file(file), file);
  }
}

std::vector<RareEstimate> estimate(const Experiment& experiment, const RareRequest& request) {
  Progress progress(suitable_progress_style(request.execution.loudness), "repetitions");
  RareSettings settings{.particles = request.particles, .score = request.score, .threads = request.execution.threads};
  settings.stop = &stop_on_interrupt();
  std::size_t earlier = 0;
  settings.on_progress = [&, last = std::pair<std::size_t, std::size_t>{}](std::size_t condition, std::size_t done,
                                                                           std::size_t planned) mutable {
    if (condition != last.first) earlier += last.second;
    last = {condition, done};
    progress.show(earlier + done, earlier + planned);
  };
  settings.seconds = request.at_most_work;
  settings.elapsed_seconds = [&progress] { return progress.elapsed(); };
  return rare_probabilities(experiment, request.question, settings);
}

ExitCode find_rare(const RareRequest& request) {
  const Experiment experiment = load_experiment(request.file, request.overrides);
  refuse_certainty(experiment, request.file);  // before any file is written
  const std::filesystem::path file = std::filesystem::path(request.folder) / "rare.json";
  expect_free(file, request.overwrite);
  ensure_writable(request.folder);
  const RareReport report =
      rare_report(experiment, {.question = request.question, .score = request.score, .particles = request.particles},
                  estimate(experiment, request));
  const std::string text = rare_document().text(report);
  expect_free(file, request.overwrite);
  write_atomically(file, text);
  const std::string title = experiment.title.empty() ? "" : experiment.title + "\n\n";
  const std::string where = fmt::format("numbers: {}\n", file.string());
  print_result(request.execution.loudness.json ? text : base::printable(title + rare_table(report) + where));
  return ExitCode::done;
}

void add_question(CLI::App& command, RareRequest& request) {
  command
      .add_option("--relative-error", request.question.relative_error,
                  "Standard error over the probability that is aimed at")
      ->check(number(1e-3, 1.0))
      ->capture_default_str()
      ->type_name("E");
  command
      .add_option("--peak-tilt", request.question.event.peak_tilt,
                  "Ask for abs(Theta) > A instead of overturning; 1 is the unstable equilibrium")
      ->check(number(0.0, 100.0))
      ->type_name("A");
  add_duration(command, "--at-most-work", request.at_most_work,
               "Stop after this time for all conditions together, e.g. 10min; what is finished then counts");
  command.add_option("--particles", request.particles, "Trajectories of a repetition at each level")
      ->check(whole_number(least_particles, most_particles))
      ->capture_default_str()
      ->type_name("N");
  const auto set_score = [&request](const std::string& name) {
    request.score = name == "energy" ? rare::Score::energy : rare::Score::tilt;
  };
  command
      .add_option_function<std::string>("--score", set_score,
                                        "What measures how near a motion is to the event: tilt or energy")
      ->check(one_of({"tilt", "energy"}))
      ->type_name("tilt|energy");
}

}  // namespace

void add_rare(CLI::App& app, Action& action) {
  const auto request = std::make_shared<RareRequest>();
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
