#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "pages/animation.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"
#include "trajectory_output.hpp"

namespace rocking::program {
namespace {

struct TrajectoryRequest {
  std::string file;
  RealisationKey key;
  std::optional<std::int64_t> periods;
  int samples = 0;
  std::string page;  ///< file; empty: none
  Overrides overrides;
  TrajectoryOutput output;
  Loudness loudness;
};

ExitCode write_animation_page(const TrajectoryRequest& request, const Experiment& experiment, std::int64_t periods) {
  const auto text = pages::animation_page_of(experiment, request.key, TrajectoryExtent(periods, request.samples));
  if (!text) throw UsageError("--html: the block overturns before two samples were taken; give more --samples");
  write_atomically(request.page, *text);
  print_result(request.loudness.json ? facts_text(std::vector<Fact>{{"written", std::vector{request.page}}})
                                     : base::printable(request.page + '\n'));
  return ExitCode::done;
}

ExitCode print_trajectory(const TrajectoryRequest& request) {
  expect_consistent(request.output, request.loudness);
  const Experiment experiment = load_experiment(request.file, request.overrides);
  const std::size_t conditions = experiment.conditions.size();
  if (request.key.condition >= conditions) {
    throw UsageError(fmt::format("--condition {}: the experiment has {}, counted from 0; give at most {}",
                                 request.key.condition, counted(conditions, "condition"), conditions - 1));
  }
  const Condition& condition = experiment.conditions[request.key.condition];
  const std::int64_t horizon = std::int64_t{condition.horizon.transient_periods} + condition.horizon.sampled_periods;
  const std::int64_t periods = request.periods.value_or(horizon);
  if (!request.page.empty()) return write_animation_page(request, experiment, periods);
  const auto trajectory =
      trajectory_of(condition, experiment.seed, request.key.realisation, TrajectoryExtent(periods, request.samples));
  print_result(text_of(request.key, trajectory, request.output));
  return ExitCode::done;
}

}  // namespace

void add_trajectory(CLI::App& app, Action& action) {
  const auto request = std::make_shared<TrajectoryRequest>();
  CLI::App* command = app.add_subcommand("trajectory", "Print the events and states of one realisation");
  command->footer(
      "Example: rocking trajectory experiments/headline/headline.json --condition 12 --realisation 3 --periods 20\n"
      "prints the fourth realisation of the thirteenth condition over 20 periods. Numbers start at 0. With\n"
      "`--format csv --units si` it prints a table for a spreadsheet, in seconds, radians and metres.");
  command->add_option("EXPERIMENT", request->file, "Experiment file (JSON); -: standard input")->required();
  command->add_option("--condition", request->key.condition, "Number of the condition, from 0")
      ->check(whole_number(0, random::realisation_limit - 1))
      ->capture_default_str()
      ->type_name("I");
  command->add_option("--realisation", request->key.realisation, "Number of the realisation, from 0")
      ->check(whole_number(0, random::realisation_limit - 1))
      ->capture_default_str()
      ->type_name("K");
  command->add_option("--periods", request->periods, "Periods of the excitation; default: all of the horizon")
      ->check(whole_number(1, 100'000'000))
      ->type_name("N");
  command->add_option("--samples", request->samples, "Adds a history: N states per period, evenly spaced; 0: none")
      ->check(whole_number(0, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--html", request->page,
                   "Writes a page with the animated block to this file instead of printing the trajectory")
      ->type_name("FILE");
  command
      ->add_option("--seed", request->overrides.seed,
                   "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
  add_trajectory_output(*command, request->output);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return print_trajectory(*request); }; });
}

}  // namespace rocking::program
