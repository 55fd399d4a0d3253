#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arguments.hpp"
#include "drawing.hpp"
#include "interrupt.hpp"
#include "output.hpp"
#include "program.hpp"
#include "rocking/studies/studies.hpp"

namespace rocking::program {
namespace {

struct FigureRequest {
  std::vector<std::string> files;
  std::string folder;
  analysis::Window window;
  StyleRequest style;
  Loudness loudness;
};

std::vector<analysis::OutputFile> read_all(const std::vector<std::string>& paths) {
  std::vector<analysis::OutputFile> files;
  for (const std::string& path : paths) {
    try {
      files.push_back({.path = path, .text = read_file(path)});
    } catch (const std::system_error& error) {
      throw MissingInput(error.what());
    }
  }
  return files;
}

ExitCode draw(const FigureRequest& request) {
  if (!(request.window.from < request.window.to)) {
    throw UsageError(fmt::format("--from {:g}: must be less than --to {:g}", request.window.from, request.window.to));
  }
  const analysis::FigureLook look = look_for(request.style);
  const auto figures = analysis::output_figures(read_all(request.files), request.window);
  const auto written = analysis::write_figures(figures, request.folder, stop_on_signal(), look);
  print_result(request.loudness.json ? facts_text(std::vector<Fact>{{"written", written.files}})
                                     : base::printable(fmt::format("{}\n", fmt::join(written.files, "\n"))));
  return tell(written.failures, no_figure, PictureRole::purpose);
}

}  // namespace

void add_figure(CLI::App& app, Action& action) {
  const auto request = std::make_shared<FigureRequest>();
  CLI::App* command = app.add_subcommand(
      "figure",
      "Draw output files of trajectory, bifurcation, orbits, cost, fragility, motion, rare, infer, check-normal");
  command->footer(
      "Example: rocking figure first.json second.json -o out --from 100\n"
      "draws two files that `rocking trajectory --samples 100` printed: each against time, both in one figure, their "
      "phase portrait and their Poincare section. Also draws bifurcation.json, orbits.json, cost.json, fragility.json "
      "and the output of `rocking check-normal --json`. `--style journal` draws for the column of a journal.");
  command->add_option("FILE", request->files, "JSON files that rocking printed")->required();
  command->add_option("-o,--output", request->folder, "Folder for the figures; created if necessary")
      ->required()
      ->type_name("DIR");
  command->add_option("--from", request->window.from, "First excitation period of trajectories to show")
      ->check(number(0.0, 1e9))
      ->capture_default_str()
      ->type_name("P");
  command->add_option("--to", request->window.to, "Last excitation period of trajectories to show; default: the last")
      ->check(number(0.0, 1e9))
      ->type_name("P");
  add_style(*command, request->style);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return draw(*request); }; });
}

}  // namespace rocking::program
