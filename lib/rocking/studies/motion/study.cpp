#include "rocking/studies/motion/study.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/fields/container_types.hpp"
#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

/// The one of this name, which check_fields has found.
template <class Enumeration, std::size_t count>
Enumeration named(const std::array<std::string_view, count>& names, const std::string& name) {
  return static_cast<Enumeration>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Numbers that belong together, each with its rule.
void check_numbers(std::string_view name, const std::vector<double>& numbers, const std::vector<const Rule*>& rules,
                   const std::string& what) {
  if (numbers.size() != rules.size()) {
    throw UnfitQuestion(std::string(name), std::to_string(numbers.size()) + " numbers", "must be " + what);
  }
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i]->allows(numbers[i])) continue;
    throw UnfitQuestion(std::string(name), base::shortest(numbers[i]), std::string(rules[i]->demand));
  }
}

void check_question(const MotionQuestion& question) {
  check_fields(question);
  if (question.format == "columns" && !question.units) {
    throw UnfitQuestion("units", "", "is missing: columns do not state the unit of the accelerations",
                        "give " + record_units_in_words());
  }
  if (question.vertical && question.files.size() > 1) {
    throw UnfitQuestion("vertical", *question.vertical, "belongs to one file, of which there are more");
  }
  if (question.block) {
    check_numbers("block", *question.block, {&rules::length, &rules::length}, "two lengths, width and height");
  }
  if (question.building) {
    check_numbers("building", *question.building,
                  {&rules::building_frequency_hz, &rules::damping_ratio, &rules::height_ratio},
                  "three numbers, frequency, damping ratio and height");
  }
}

Building building_of(const std::vector<double>& numbers) {
  return {.frequency_hz = numbers[0], .damping_ratio = numbers[1], .height_ratio = numbers[2]};
}

std::shared_ptr<const GroundMotion> floor_of(const GroundMotion& ground, const Building& building) {
  GroundMotion floor = ground;
  floor.samples = floor_motion(ground.samples, building);
  floor.name += " (floor)";
  floor.header_peak.reset();
  floor.declared.reset();
  floor.warnings.clear();
  if (floor.samples.size() > 1) floor.time_step = floor.samples[1].time - floor.samples[0].time;
  return std::make_shared<const GroundMotion>(std::move(floor));
}

}  // namespace

std::vector<MeasuredMotion> motion(const MotionQuestion& question) {
  check_question(question);
  GroundMotionReading how{.time_step = question.time_step,
                          .gravity = question.gravity,
                          .vertical_name = question.vertical.value_or(""),
                          .component = question.component.value_or("")};
  if (question.format != "auto") how.format = named<RecordFormat>(record_format_choices, question.format);
  for (const std::string& column : question.columns) {
    how.columns.push_back(named<RecordColumn>(record_column_names, column));
  }
  if (!how.columns.empty()) {
    if (const auto refusal = refuse_columns(how.columns, how.time_step.has_value())) {
      refuse("columns", "", refusal->reason + "; " + refusal->remedy);
    }
  }
  if (question.units) how.unit = named<RecordUnit>(record_unit_names, *question.units);
  GroundMotionFiles files(files_seen_from(""));
  Problems problems;
  std::vector<MeasuredMotion> motions;
  for (const std::string& file : question.files) {
    how.name = file;
    const auto read = files.motion(how, problems);
    if (!read) continue;
    motions.push_back(measured(read, files.digest(file), question));
    if (!question.building) continue;
    motions.push_back(measured(floor_of(*read, building_of(*question.building)), files.digest(file), question));
    motions[motions.size() - 2].floor_peak_g = motions.back().measures.pga_g;
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return motions;
}

const StructType& fields_of(const MotionQuestion*) {
  using Type = MotionQuestion;
  static const StructType fields{
      "MotionQuestion",
      asked(field<&Type::files>("files", "Ground motions"), {.names = "FILE", .letter = "FILE"}),
      asked(field<&Type::format>("format", "Format of the files; auto: recognised by their first lines",
                                 Rule{.choices = record_format_choices}),
            {.names = "--format", .letter = "NAME"}),
      asked(field<&Type::units>("units",
                                "Unit of the accelerations; must agree with a file that states it; required with the "
                                "format columns; default: that of the file, or m/s2",
                                Rule{.choices = record_unit_names}),
            {.names = "--units", .letter = "UNIT"}),
      asked(field<&Type::time_step>("time_step", "Of columns without times [s]", rule::positive),
            {.names = "--time-step", .letter = "DT"}),
      asked(field<&Type::columns>("columns",
                                  "What the columns of a file of numbers are, in its order, between blanks or commas: "
                                  "time, horizontal, vertical, other (not used)",
                                  Rule{.choices = record_column_names}),
            {.names = "--columns", .letter = "NAME...", .kind = FlagKind::words}),
      asked(field<&Type::component>("component", "Of files that hold several, as their headers name it: N10E, 90"),
            {.names = "--component", .letter = "NAME"}),
      asked(field<&Type::vertical>("vertical", "File with the vertical component"),
            {.names = "--vertical", .letter = "FILE"}),
      asked(field<&Type::gravity>("gravity", "What 1 g is [m/s^2]", rule::positive),
            {.names = "--gravity", .letter = "G"}),
      asked(field<&Type::periods>("periods", "Periods of the response spectrum [s]", rule::positive),
            {.names = "--periods", .letter = "T..."}),
      asked(
          field<&Type::damping>("damping", "Damping ratio of the response spectrum", Rule{.least = 0.0, .below = 1.0}),
          {.names = "--damping", .letter = "RATIO"}),
      asked(field<&Type::series>(
                "series", "Add the motions sample by sample, and fine spectra: with --json, for `rocking report`"),
            {.names = "--series", .kind = FlagKind::on}),
      asked(field<&Type::block>("block", "Width and height of a block [m], whose least scale of uplift is printed"),
            {.names = "--block", .letter = "W H", .count = 2}),
      asked(field<&Type::building>("building",
                                   "Frequency [Hz] and damping ratio of a uniform shear building, and the height of a "
                                   "floor over that of the building: its motion is measured beside that of the ground"),
            {.names = "--building", .letter = "F Z H", .count = 3}),
  };
  return fields;
}

namespace {

/// The names of columns end at the first word that is none; the others are files.
void part_columns_from_files(MotionQuestion& question) {
  const auto is_name = [](const std::string& word) {
    return std::ranges::find(record_column_names, word) != record_column_names.end();
  };
  const auto first_file = std::ranges::find_if_not(question.columns, is_name);
  if (first_file == question.columns.begin() && !question.columns.empty()) {
    throw UnfitQuestion("columns", question.columns.front(), "is no name of a column",
                        "give time, horizontal, vertical, other, in the order of the file");
  }
  question.files.insert(question.files.end(), first_file, question.columns.end());
  question.columns.erase(first_file, question.columns.end());
}

void check(const Subject&, MotionQuestion& question) {
  part_columns_from_files(question);
  if (question.files.empty()) throw UnfitQuestion("files", "", "is required");
  check_question(question);
}

std::vector<std::string> warnings_of(const std::vector<MeasuredMotion>& motions) {
  std::vector<std::string> warnings;
  for (const MeasuredMotion& found : motions) {
    for (const std::string& warning : found.motion->warnings) warnings.push_back(found.motion->name + ": " + warning);
  }
  return warnings;
}

std::vector<analysis::Figure> figures_of(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question) {
  std::vector<analysis::Figure> figures =
      analysis::motion_figures(motion_report(motions, question, MotionDetail::series));
  for (std::size_t i = 0; i + 1 < figures.size() && motions.size() > 1; ++i) {
    figures[i].name += '_' + std::to_string(i + 1);
  }
  return figures;
}

Answer find(const Subject&, const MotionQuestion& question, const Circumstances& circumstances) {
  const std::vector<MeasuredMotion> motions = motion(question);
  const MotionDetail detail = question.series ? MotionDetail::series : MotionDetail::measures;
  const MotionReport report = motion_report(motions, question, detail);
  Answer answer{.document = motion_document().text(report),
                .table = motion_table(report, circumstances.extent),
                .warnings = warnings_of(motions)};
  if (circumstances.draws) {
    answer.table += '\n';
    answer.figures = figures_of(motions, question);
  }
  return answer;
}

MotionQuestion of_command() {
  MotionQuestion question;
  question.series = false;
  return question;
}

constexpr StudyFunctions<MotionQuestion> functions{.of_command = of_command,
                                                   .check = check,
                                                   .find = find,
                                                   .figures = figures_in<motion_document, analysis::motion_figures>};

}  // namespace

const Study& motion_study() {
  static const Study study = study_of<MotionQuestion, functions>({
      .name = "motion",
      .sentence = "Read ground motions, and print their intensity measures",
      .example = "record.at2 --periods 0.2 0.5 1 --block 0.35 1.6 --figure out",
      .text = "prints what was read, peak acceleration, velocity and displacement, Arias intensity, cumulative "
              "absolute velocity, significant duration, the response spectrum, and the least scale at which the block "
              "rocks; draws the motion and its spectra into the folder out.",
      .python_notes = "Columns are needed where there are more than a time and an acceleration, or a header. Raises "
                      "InputError with file, line and value of each fault.",
      .python_example = R"(>>> import os, rocking, tempfile
>>> path = os.path.join(tempfile.mkdtemp(), "pulse.txt")
>>> with open(path, "w") as file:
...     _ = file.write("0 0\n0.5 4.905\n1 0\n")
>>> record = rocking.motion(path, units="m/s2", block=(1.0, 4.0)).motions[0]
>>> record.pga_g, record.uplift_scale
(0.5, 0.5)
>>> record.series.acceleration_g
array([0. , 0.5, 0. ]))",
      .subject = SubjectKind::files,
      .has_long_table = true,
      .draws = true,
      .document = motion_document(),
      .without_figures = {.place = "/motions/0/series",
                          .value = "",
                          .reason = "is missing",
                          .remedy = "write the file with `rocking motion --json --series`",
                          .where = {}},
  });
  return study;
}

}  // namespace rocking
