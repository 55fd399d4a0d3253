#include <memory>
#include <string>
#include <vector>

#include "program.hpp"
#include "report_again.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_report(CLI::App& app, Action& action) {
  const std::vector<std::string> all_formats{"html", "csv", "gnuplot", "latex", "text"};
  const auto request = std::make_shared<ReportRequest>();
  request->formats = {"html", "csv", "gnuplot", "latex"};
  CLI::App* command = app.add_subcommand("report", "Write page, figures and tables of a finished run again (a folder)");
  command->footer(
      "Example: rocking report out --format html,gnuplot\n"
      "html: out/report.html, a page that needs no other file. gnuplot: the figures in out/figures, each as data "
      "(tsv), script (gp) and pictures drawn by gnuplot (svg, png, pdf). csv and latex: tables in out/tables. text: "
      "the table of response modes, on standard output.");
  command->add_option("DIR", request->folder, "Folder of the run")->required();
  command
      ->add_option("--format", request->formats,
                   "What to write, separated by commas, all files by default; text prints the table of response modes")
      ->delimiter(',')
      ->check(one_of(all_formats))
      ->type_name("LIST");
  request->hazard.add_to(*command, "page and figures of a suite then tell its annual rates");
  add_style(*command, request->style);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return report_again(*request); }; });
}

}  // namespace rocking::program
