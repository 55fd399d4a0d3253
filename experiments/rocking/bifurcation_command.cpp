#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/bifurcation_report.hpp"
#include "rocking/output/bifurcation_table.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/studies/bifurcation.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct BifurcationRequest {
  std::string file;
  std::string folder;
  std::uint64_t realisation = 0;
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
  bool overwrite = false;
};

struct DiagramFiles {
  std::filesystem::path json;
  std::filesystem::path csv;
  std::vector<std::filesystem::path> tables;  ///< of the diagrams of a grid
};

/// Of an experiment with diagrams.
DiagramFiles files_in(const std::filesystem::path& folder, const Experiment& experiment) {
  DiagramFiles files{.json = folder / (std::string(bifurcation_file) + ".json"),
                     .csv = folder / (std::string(bifurcation_file) + ".csv"),
                     .tables = {}};
  const std::vector<Diagram> diagrams = diagrams_of(experiment);
  if (diagrams.size() < 2) return files;
  for (const std::string& name : diagram_names(experiment, diagrams)) files.tables.push_back(folder / (name + ".csv"));
  return files;
}

void expect_all_free(const DiagramFiles& files, bool overwrite) {
  expect_free(files.json, overwrite);
  expect_free(files.csv, overwrite);
  expect_free(files.tables, overwrite);
}

std::vector<Diagram> draw(const Experiment& experiment, const BifurcationRequest& request) {
  Progress progress(suitable_progress_style(request.execution.loudness), "steps");
  return rocking::bifurcation(experiment, request.realisation, watched(request.execution, progress));
}

/// Throws InputError, with the file and the line, where the experiment has no diagram.
void refuse_without_diagrams(const Experiment& experiment, const ExperimentText& source) {
  try {
    static_cast<void>(diagrams_of(experiment));
  } catch (const base::InputError& error) {
    throw located(error, source.text, source.name);
  }
}

ExitCode bifurcation(const BifurcationRequest& request) {
  const ExperimentText source = load_experiment_text(request.file);
  const Experiment experiment = load_experiment(source, request.overrides);
  refuse_without_diagrams(experiment, source);  // before any file is written
  const DiagramFiles files = files_in(request.folder, experiment);
  expect_all_free(files, request.overwrite);
  ensure_writable(request.folder);
  const DrawnDiagrams drawn{
      .experiment = &experiment, .realisation = request.realisation, .diagrams = draw(experiment, request)};
  const std::string text =
      bifurcation_document().text(bifurcation_report(experiment, request.realisation, drawn.diagrams));
  expect_all_free(files, request.overwrite);
  write_atomically(files.csv, bifurcation_csv(drawn));
  const std::vector<DiagramTable> tables = diagram_tables(drawn);
  for (std::size_t i = 0; i < tables.size(); ++i) write_atomically(files.tables[i], tables[i].csv);
  write_atomically(files.json, text);
  const std::string title = experiment.title.empty() ? "" : experiment.title + "\n\n";
  std::string where = fmt::format("points: {}, {}\n", files.json.string(), files.csv.string());
  for (const auto& table : files.tables) where += fmt::format("        {}\n", table.string());
  print_result(request.execution.loudness.json ? text : base::printable(title + bifurcation_table(drawn) + where));
  return ExitCode::done;
}

}  // namespace

void add_bifurcation(CLI::App& app, Action& action) {
  const auto request = std::make_shared<BifurcationRequest>();
  CLI::App* command =
      app.add_subcommand("bifurcation", "Follow the responses along a swept parameter; shows which coexist");
  command->footer(
      "Example: rocking bifurcation experiments/reference_block/no_sliding.json -o out\n"
      "runs every step of the sweep from the initial state of the file, and from the end of the previous step, upwards "
      "and\n"
      "downwards. Writes the strobe points to out/bifurcation.json and out/bifurcation.csv and prints the responses. "
      "In a\n"
      "grid there is one diagram for each combination of values of the entries after the first; its points are also "
      "in a\n"
      "file named by these values, such as out/bifurcation_static_0.35.csv.");
  command->add_option("EXPERIMENT", request->file, "Experiment file (JSON) with a sweep; -: standard input")
      ->required();
  command->add_option("-o,--output", request->folder, "Folder for the results; created if necessary")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--realisation", request->realisation,
                   "Realisation whose random numbers are used, if something is random")
      ->check(whole_number(0, random::realisation_limit - 1))
      ->capture_default_str()
      ->type_name("K");
  add_threads(*command, request->execution);
  command
      ->add_option("--seed", request->overrides.seed,
                   "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
  command->add_flag("--overwrite", request->overwrite, "Replace the files of these names in the folder");
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return bifurcation(*request); }; });
}

}  // namespace rocking::program
