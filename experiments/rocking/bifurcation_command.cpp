#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "experiment_argument.hpp"
#include "machine.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/bifurcation_report.hpp"
#include "rocking/output/bifurcation_table.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/studies/bifurcation.hpp"
#include "rocking/text/files.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct BifurcationCommand {
  std::string experiment;
  StudyFile file{std::string(bifurcation_file) + ".json", "points"};
  std::uint64_t realisation = 0;
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

/// The points as CSV: all of them, and those of each diagram of a grid.
std::vector<std::filesystem::path> tables_in(const std::filesystem::path& folder, const Experiment& experiment,
                                             const std::vector<Diagram>& diagrams) {
  std::vector<std::filesystem::path> files{folder / (std::string(bifurcation_file) + ".csv")};
  if (diagrams.size() < 2) return files;
  for (const std::string& name : diagram_names(experiment, diagrams)) files.push_back(folder / (name + ".csv"));
  return files;
}

std::vector<Diagram> draw(const Experiment& experiment, const BifurcationCommand& command) {
  Progress progress(suitable_progress_style(command.execution.loudness), "steps");
  return rocking::bifurcation(experiment, command.realisation, watched(command.execution, progress));
}

void expect_free(const BifurcationCommand& command, const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) command.file.expect_free(file);
}

/// Writes the points as CSV and as JSON; the lines that say so.
std::string write(const BifurcationCommand& command, const DrawnDiagrams& drawn, std::string_view text,
                  const std::vector<std::filesystem::path>& files) {
  expect_free(command, files);
  write_atomically(files.front(), bifurcation_csv(drawn));
  const std::vector<DiagramTable> tables = diagram_tables(drawn);
  for (std::size_t i = 0; i < tables.size(); ++i) write_atomically(files[i + 1], tables[i].csv);
  std::string where = command.file.write(text);
  constexpr std::size_t most_named = 4;
  const bool names_all = command.execution.extent == Extent::all || files.size() <= most_named;
  for (const auto& file : std::span(files).first(names_all ? files.size() : 1)) {
    where += fmt::format("        {}\n", file.string());
  }
  if (!names_all) where += fmt::format("        and one file for each diagram, {} in all\n", files.size() - 1);
  return where;
}

ExitCode bifurcation(BifurcationCommand& command) {
  const ExperimentText source = load_experiment_text(command.experiment);
  const Experiment experiment = load_experiment(source, command.overrides);
  std::vector<std::filesystem::path> files;
  check_source(source, [&] { files = tables_in(command.file.folder(), experiment, diagrams_of(experiment)); });
  expect_free(command, files);
  command.file.prepare();
  const DrawnDiagrams drawn{
      .experiment = &experiment, .realisation = command.realisation, .diagrams = draw(experiment, command)};
  const std::string text =
      bifurcation_document().text(bifurcation_report(experiment, command.realisation, drawn.diagrams));
  deliver_study(command.execution.loudness, text,
                heading(experiment) + bifurcation_table(drawn, command.execution.extent),
                [&] { return write(command, drawn, text, files); });
  return ExitCode::done;
}

}  // namespace

void add_bifurcation(CLI::App& app, Action& action) {
  const auto request = std::make_shared<BifurcationCommand>();
  CLI::App* command =
      app.add_subcommand("bifurcation", "Follow the responses along a swept parameter; shows which coexist");
  command->footer(
      "Example: rocking bifurcation experiments/reference_block/no_sliding.json -o out\n"
      "runs every step of the sweep from the initial state of the file, and from the end of the previous step, upwards "
      "and downwards. Writes the strobe points to out/bifurcation.json and out/bifurcation.csv and prints the "
      "responses. In a grid there is one diagram for each combination of values of the entries after the first; its "
      "points are also in a file named by these values, such as out/bifurcation_static_0.35.csv.");
  add_experiment(*command, request->experiment);
  request->file.add_to(*command, true);
  command
      ->add_option("--realisation", request->realisation,
                   "Realisation whose random numbers are used, if something is random")
      ->check(whole_number(0, random::realisation_limit - 1))
      ->capture_default_str()
      ->type_name("K");
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  add_extent(*command, request->execution.extent);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return bifurcation(*request); }; });
}

}  // namespace rocking::program
