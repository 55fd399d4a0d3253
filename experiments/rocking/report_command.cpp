#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "program.hpp"
#include "report_again.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_report(CLI::App& app, Action& action) {
  const std::vector<std::string> all_formats{"html", "csv", "gnuplot", "latex", "text"};
  const auto request = std::make_shared<ReportRequest>();
  request->formats = {"html", "csv", "gnuplot", "latex"};
  CLI::App* command = app.add_subcommand(
      "report", "Write page, figures and tables of a finished run again, or draw files that rocking printed");
  command->footer(
      "Example: rocking report out --format html,gnuplot\n"
      "html: out/report.html, a page that needs no other file. gnuplot: the figures in out/figures, each as numbers "
      "(tsv) and a picture. csv and latex: tables in out/tables. text: the table of response modes, on standard "
      "output.\n"
      "`rocking report first.json second.json -o drawn --from 100` draws two files that `rocking trajectory --samples "
      "100` printed: each against time, both in one figure, their phase portrait and their Poincare section. It also "
      "draws bifurcation.json, orbits.json, threshold.json, cost.json, fragility.json, rare.json, infer.json, and what "
      "`rocking motion --json` and `rocking check-normal --json` print. `--style journal` draws for the column of a "
      "journal.");
  command->add_option("PATH", request->paths, "Folder of the run; or, with -o, JSON files that rocking printed")
      ->required();
  CLI::Option* drawn =
      command->add_option("-o,--output", request->drawn, "Folder for the figures of files; created if necessary")
          ->type_name("DIR");
  const auto add_bound = [&](const char* name, double& bound, const char* description) {
    return command->add_option(name, bound, description)->check(number(0.0, 1e9))->type_name("P")->needs(drawn);
  };
  add_bound("--from", request->window.from, "First excitation period of trajectories to show")->capture_default_str();
  add_bound("--to", request->window.to, "Last excitation period of trajectories to show; default: the last");
  CLI::Option* formats =
      command
          ->add_option(
              "--format", request->formats,
              "What to write, separated by commas, all files by default; text prints the table of response modes")
          ->delimiter(',')
          ->check(one_of(all_formats))
          ->type_name("LIST");
  request->hazard.add_to(*command, "page and figures of a suite then tell its annual rates");
  add_style(*command, request->style);
  add_loudness(*command, request->loudness);
  drawn->excludes(formats);
  command->final_callback([&action, request, drawn] {
    if (!drawn->empty()) {
      action = [request] { return draw_files(*request); };
      return;
    }
    if (request->paths.size() > 1) throw CLI::RequiredError("-o DIR (the folder for the figures of files)");
    request->paths.front() = folder_of_run(request->paths.front());
    action = [request] { return report_again(*request); };
  });
}

}  // namespace rocking::program
