#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/output/write_fragility.hpp"
#include "rocking/studies/fragility.hpp"
#include "rocking/text/files.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct FragilityRequest {
  std::vector<std::string> folders;
  std::string output;  ///< empty: nothing is written
  bool overwrite = false;
  Loudness loudness;
};

RunFragility fragility_of(const std::string& name) {
  const RunFolder folder(name);
  const Store store = folder.open_sound_store();
  RunFragility run{.experiment = experiment_of(store.identity()), .curves = {}};
  if (intensity_of(run.experiment).empty()) {
    throw UsageError(name +
                     ": sweeps no intensity of the excitation; give a run whose sweep has /excitation/amplitude (or "
                     "amplitude_g, amplitude_m_s2) or /excitation/scale (or pga_g, pgv_m_s)");
  }
  if (run.experiment.conditions.front().until) {
    throw UsageError(
        name +
        ": its number of realisations was determined by `until`, which a fragility function does not allow; give a "
        "run with a fixed number of realisations");
  }
  try {
    run.curves = fragility(run.experiment, store);
  } catch (const base::InputError& error) {
    throw MissingInput(fmt::format("{}: {}", name, error.what()));
  }
  return run;
}

std::filesystem::path curve_file_in(const std::string& folder) {
  return std::filesystem::path(folder) / "fragility.json";
}

ExitCode fragility(const FragilityRequest& request) {
  if (!request.output.empty() && !request.overwrite && std::filesystem::exists(curve_file_in(request.output))) {
    throw InTheWay(curve_file_in(request.output).string() +
                   ": already exists; choose another folder, or add --overwrite to replace it");
  }
  std::vector<RunFragility> runs;
  for (const std::string& name : request.folders) runs.push_back(fragility_of(name));
  const std::string text = fragility_text(runs);
  std::string table = fragility_table(runs);
  if (!request.output.empty()) {
    ensure_writable(request.output);
    write_atomically(curve_file_in(request.output), text);
    table += fmt::format("numbers: {}\n", curve_file_in(request.output).string());
  }
  print_result(request.loudness.json ? text : base::printable(table));
  return ExitCode::done;
}

}  // namespace

void add_fragility(CLI::App& app, Action& action) {
  const auto request = std::make_shared<FragilityRequest>();
  CLI::App* command = app.add_subcommand("fragility", "Fit the probability of overturning as a function of intensity");
  command->footer(
      "Example: rocking fragility out -o out\n"
      "counts for each amplitude (or scale of a ground motion) the realisations that overturned, with exact intervals, "
      "and fits\n"
      "a lognormal fragility function with its band. A grid has one curve for each combination of values of the other "
      "entries;\n"
      "the curves of several runs are shown together. `-o` saves the numbers in out/fragility.json, which `rocking "
      "figure`\n"
      "draws.");
  command->add_option("DIR", request->folders, "Folders of finished runs")->required();
  command->add_option("-o,--output", request->output, "Folder for fragility.json; created if necessary")
      ->type_name("DIR");
  command->add_flag("--overwrite", request->overwrite, "Replace fragility.json in the folder");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return fragility(*request); }; });
}

}  // namespace rocking::program
