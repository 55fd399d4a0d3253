#include <algorithm>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/motion_figure.hpp"
#include "commands.hpp"
#include "drawing.hpp"
#include "output.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/output/motion_report.hpp"
#include "rocking/scene/rules.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

struct MotionRequest {
  GroundMotionRequest motions{.files = {},
                              .question = {.periods = {0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0}}};
  std::vector<double> block;  ///< width and height [m]; empty: none
  bool series = false;
  std::string figures;  ///< folder; empty: nothing is drawn
  StyleRequest style;
  Extent extent = Extent::one_screen;
  Loudness loudness;
};

GroundMotionRequest asked(const MotionRequest& request) {
  GroundMotionRequest asked = request.motions;
  if (request.block.empty()) return asked;
  for (const double length : request.block) {
    if (!rules::length.allows(length)) throw UsageError(fmt::format("--block {:g}: {}", length, rules::length.demand));
  }
  asked.question.block = dynamics::Block{request.block[0], request.block[1], asked.question.gravity};
  return asked;
}

/// The names of columns end at the first word that is none; the others are files.
void part_columns_from_files(GroundMotionRequest& request) {
  const auto is_name = [](const std::string& word) {
    return std::ranges::find(record_column_names, word) != record_column_names.end();
  };
  const auto first_file = std::ranges::find_if_not(request.columns, is_name);
  if (first_file == request.columns.begin() && !request.columns.empty()) {
    throw UsageError(fmt::format("--columns {}: give time, horizontal, vertical, other, in the order of the file",
                                 request.columns.front()));
  }
  request.files.insert(request.files.end(), first_file, request.columns.end());
  request.columns.erase(first_file, request.columns.end());
}

void check_usage(const GroundMotionRequest& request) {
  if (request.files.empty()) throw UsageError("FILE is required");
  if (request.format == "columns" && !request.units) {
    throw UsageError("--format columns: does not state the unit of the accelerations; add --units " +
                     record_units_in_words());
  }
  if (request.vertical && request.files.size() > 1) {
    throw UsageError("--vertical: belongs to one file; give one FILE");
  }
}

std::vector<MeasuredMotion> measure_all(const GroundMotionRequest& request) {
  try {
    return rocking::motion(request);
  } catch (const std::system_error& error) {
    throw MissingInput(error.what());
  }
}

void tell_warnings(const std::vector<MeasuredMotion>& motions) {
  for (const MeasuredMotion& found : motions) {
    for (const std::string& warning : found.motion->warnings) {
      print_notice(fmt::format("{}: {}", found.motion->name, warning));
    }
  }
}

ExitCode motion(MotionRequest request) {
  part_columns_from_files(request.motions);
  check_usage(request.motions);
  const analysis::FigureLook look = look_for(request.style);
  const GroundMotionRequest wanted = asked(request);
  const MotionQuestion& question = wanted.question;
  const std::vector<MeasuredMotion> motions = measure_all(wanted);
  if (!request.loudness.quiet) tell_warnings(motions);
  WrittenFigures written;
  if (!request.figures.empty()) {
    std::vector<analysis::Figure> figures =
        analysis::motion_figures(motion_report(motions, question, MotionDetail::series));
    for (std::size_t i = 0; i + 1 < figures.size() && motions.size() > 1; ++i) {
      figures[i].name += fmt::format("_{}", i + 1);
    }
    written = write_figures(figures, request.figures, look);
  }
  const MotionDetail detail = request.series ? MotionDetail::series : MotionDetail::measures;
  const MotionReport report = motion_report(motions, question, detail);
  if (request.loudness.json) {
    print_result(motion_document().text(report));
  } else {
    std::string text = motion_table(report, request.extent);
    if (!written.files.empty()) text += fmt::format("\n{}\n", fmt::join(written.files, "\n"));
    print_result(base::printable(text));
  }
  return written.failures.tell(no_figure, PictureRole::purpose);
}

void add_reading_options(CLI::App& command, GroundMotionRequest& request) {
  command.add_option("--format", request.format, "Format of the files; auto: recognised by their first lines")
      ->check(one_of({record_format_choices.begin(), record_format_choices.end()}))
      ->capture_default_str()
      ->type_name("NAME");
  command.add_option("--units", request.units, "Unit of the accelerations; default: that of the file, or m/s2")
      ->check(one_of({record_unit_names.begin(), record_unit_names.end()}))
      ->type_name("UNIT");
  command.add_option("--time-step", request.time_step, "Of columns without times [s]")
      ->check(number(1e-9, 1e6))
      ->type_name("DT");
  command
      .add_option("--columns", request.columns,
                  "What the columns of a file of numbers are: time, horizontal, vertical, other")
      ->delimiter(',')
      ->type_name("NAME...");
  command.add_option("--vertical", request.vertical, "File with the vertical component")->type_name("FILE");
  command.add_option("--gravity", request.question.gravity, "What 1 g is [m/s^2]")
      ->check(number(1e-6, 1e6))
      ->capture_default_str()
      ->type_name("G");
}

}  // namespace

void add_motion(CLI::App& app, Action& action) {
  const auto request = std::make_shared<MotionRequest>();
  CLI::App* command = app.add_subcommand("motion", "Read ground motions, and print their intensity measures");
  command->footer(
      "Example: rocking motion record.at2 --periods 0.2 0.5 1 --block 0.35 1.6 --figure out\n"
      "prints what was read, peak acceleration, velocity and displacement, Arias intensity, cumulative absolute "
      "velocity, significant duration, the response spectrum, and the least scale at which the block rocks; draws the "
      "motion and its spectra into the folder out.");
  command->add_option("FILE", request->motions.files, "Ground motions");
  add_reading_options(*command, request->motions);
  command->add_option("--periods", request->motions.question.periods, "Periods of the response spectrum [s]")
      ->check(number(1e-3, 1e3))
      ->type_name("T...");
  command->add_option("--damping", request->motions.question.damping, "Damping ratio of the response spectrum")
      ->check(number(0.0, 0.99))
      ->capture_default_str()
      ->type_name("RATIO");
  command
      ->add_option("--block", request->block, "Width and height of a block [m], whose least scale of uplift is wanted")
      ->expected(2)
      ->type_name("W H");
  command->add_flag("--series", request->series, "Add to --json the motions sample by sample, for `rocking figure`");
  command->add_option("--figure", request->figures, "Folder for figures; created if necessary")->type_name("DIR");
  add_style(*command, request->style);
  add_extent(*command, request->extent);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return motion(*request); }; });
}

}  // namespace rocking::program
