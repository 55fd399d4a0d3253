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

void check(const GroundMotionRequest& request) {
  check_fields(request);
  if (request.format == "columns" && !request.units) {
    refuse("units", "",
           "is missing: columns do not state the unit of the accelerations; give " + record_units_in_words());
  }
  if (request.vertical && request.files.size() > 1) {
    refuse("vertical", *request.vertical, "belongs to one file, of which there are more");
  }
  if (!request.question.block) return;
  for (const double length : {request.question.block->width, request.question.block->height}) {
    if (!rules::length.allows(length)) refuse("block", base::shortest(length), std::string(rules::length.demand));
  }
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

std::vector<MeasuredMotion> motion(const GroundMotionRequest& request) {
  check(request);
  GroundMotionReading how{.time_step = request.time_step,
                          .gravity = request.question.gravity,
                          .vertical_name = request.vertical.value_or(""),
                          .component = request.component.value_or("")};
  if (request.format != "auto") how.format = named<RecordFormat>(record_format_choices, request.format);
  for (const std::string& column : request.columns) {
    how.columns.push_back(named<RecordColumn>(record_column_names, column));
  }
  if (!how.columns.empty()) {
    if (const auto refusal = refuse_columns(how.columns, how.time_step.has_value())) {
      refuse("columns", "", refusal->reason + "; " + refusal->remedy);
    }
  }
  if (request.units) how.unit = named<RecordUnit>(record_unit_names, *request.units);
  GroundMotionFiles files(files_seen_from(""));
  Problems problems;
  std::vector<MeasuredMotion> motions;
  for (const std::string& file : request.files) {
    how.name = file;
    const auto read = files.motion(how, problems);
    if (!read) continue;
    motions.push_back(measured(read, files.digest(file), request.question));
    if (!request.question.building) continue;
    motions.push_back(measured(floor_of(*read, *request.question.building), files.digest(file), request.question));
    motions[motions.size() - 2].floor_peak_g = motions.back().measures.pga_g;
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return motions;
}

const StructType& fields_of(const GroundMotionRequest*) {
  using Type = GroundMotionRequest;
  using Question = MotionQuestion;
  static const StructType fields{
      "GroundMotionRequest",
      asked(field<&Type::files>("files", "Ground motions"), {.names = "FILE", .letter = "FILE"}),
      asked(field<&Type::format>("format", "Format of the files; auto: recognised by their first lines",
                                 Rule{.choices = record_format_choices}),
            {.names = "--format", .letter = "NAME"}),
      asked(field<&Type::units>(
                "units",
                "Unit of the accelerations; must agree with a file that states it; required with the format columns; "
                "default: that of the file, or m/s2",
                Rule{.choices = record_unit_names}),
            {.names = "--units", .letter = "UNIT"}),
      asked(field<&Type::time_step>("time_step", "Of columns without times [s]", rule::positive),
            {.names = "--time-step", .letter = "DT"}),
      asked(field<&Type::columns>(
                "columns",
                "What the columns of a file of numbers are, in its order, between blanks or commas: time, horizontal, "
                "vertical, other (not used)",
                Rule{.choices = record_column_names}),
            {.names = "--columns", .letter = "NAME...", .kind = FlagKind::words}),
      asked(field<&Type::component>("component", "Of files that hold several, as their headers name it: N10E, 90"),
            {.names = "--component", .letter = "NAME"}),
      asked(field<&Type::vertical>("vertical", "File with the vertical component"),
            {.names = "--vertical", .letter = "FILE"}),
      asked(field<&Type::question, &Question::gravity>("gravity", "What 1 g is [m/s^2]", rule::positive),
            {.names = "--gravity", .letter = "G"}),
      asked(
          field<&Type::question, &Question::periods>("periods", "Periods of the response spectrum [s]", rule::positive),
          {.names = "--periods", .letter = "T..."}),
      asked(field<&Type::question, &Question::damping>("damping", "Damping ratio of the response spectrum",
                                                       Rule{.least = 0.0, .below = 1.0}),
            {.names = "--damping", .letter = "RATIO"}),
      asked(field<&Type::series>(
                "series", "Add the motions sample by sample, and fine spectra: with --json, for `rocking report`"),
            {.names = "--series", .kind = FlagKind::on}),
  };
  return fields;
}

namespace {

/// A request, and the size of a block. Callers in Python want the samples.
struct FilesQuestion {
  GroundMotionRequest request{
      .files = {}, .series = true, .question = {.periods = {0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0}}};
  std::optional<std::vector<double>> block = {};     ///< width and height [m]
  std::optional<std::vector<double>> building = {};  ///< frequency [Hz], damping ratio, and height of the floor
};

const StructType& fields_of(const FilesQuestion*) {
  static const StructType fields{
      "FilesQuestion",
      inlined<&FilesQuestion::request>(),
      asked(field<&FilesQuestion::block>("block",
                                         "Width and height of a block [m], whose least scale of uplift is printed"),
            {.names = "--block", .letter = "W H", .count = 2}),
      asked(field<&FilesQuestion::building>(
                "building",
                "Frequency [Hz] and damping ratio of a uniform shear building, and the height of a floor over that of "
                "the building: its motion is measured beside that of the ground"),
            {.names = "--building", .letter = "F Z H", .count = 3}),
  };
  return fields;
}

/// The names of columns end at the first word that is none; the others are files.
void part_columns_from_files(GroundMotionRequest& request) {
  const auto is_name = [](const std::string& word) {
    return std::ranges::find(record_column_names, word) != record_column_names.end();
  };
  const auto first_file = std::ranges::find_if_not(request.columns, is_name);
  if (first_file == request.columns.begin() && !request.columns.empty()) {
    throw UnfitQuestion("--columns " + request.columns.front() +
                        ": give time, horizontal, vertical, other, in the order of the file");
  }
  request.files.insert(request.files.end(), first_file, request.columns.end());
  request.columns.erase(first_file, request.columns.end());
}

void take_block(FilesQuestion& question) {
  if (!question.block) return;
  if (question.block->size() != 2) throw UnfitQuestion("--block: give two lengths, width and height");
  for (const double length : *question.block) {
    if (rules::length.allows(length)) continue;
    throw UnfitQuestion("--block " + base::shortest(length) + ": " + std::string(rules::length.demand));
  }
  MotionQuestion& asked = question.request.question;
  asked.block = dynamics::Block{question.block->front(), question.block->back(), asked.gravity};
}

void take_building(FilesQuestion& question) {
  if (!question.building) return;
  if (question.building->size() != 3) {
    throw UnfitQuestion("--building: give three numbers, frequency, damping ratio and height");
  }
  const std::array<const Rule*, 3> bounds{&rules::building_frequency_hz, &rules::damping_ratio, &rules::height_ratio};
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const double number = (*question.building)[i];
    if (!bounds[i]->allows(number)) {
      throw UnfitQuestion("--building " + base::shortest(number) + ": " + std::string(bounds[i]->demand));
    }
  }
  const std::vector<double>& numbers = *question.building;
  question.request.question.building =
      Building{.frequency_hz = numbers[0], .damping_ratio = numbers[1], .height_ratio = numbers[2]};
}

void check(const Subject&, FilesQuestion& question) {
  GroundMotionRequest& request = question.request;
  part_columns_from_files(request);
  if (request.files.empty()) throw UnfitQuestion("FILE is required");
  if (request.format == "columns" && !request.units) {
    throw UnfitQuestion("--format columns: does not state the unit of the accelerations; add --units " +
                        record_units_in_words());
  }
  if (request.vertical && request.files.size() > 1) {
    throw UnfitQuestion("--vertical: belongs to one file; give one FILE");
  }
  take_block(question);
  take_building(question);
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

Answer find(const Subject&, const FilesQuestion& question, const Circumstances& circumstances) {
  const MotionQuestion& asked = question.request.question;
  const std::vector<MeasuredMotion> motions = motion(question.request);
  const MotionDetail detail = question.request.series ? MotionDetail::series : MotionDetail::measures;
  const MotionReport report = motion_report(motions, asked, detail);
  Answer answer{.document = motion_document().text(report),
                .table = motion_table(report, circumstances.extent),
                .warnings = warnings_of(motions)};
  if (circumstances.draws) {
    answer.table += '\n';
    answer.figures = figures_of(motions, asked);
  }
  return answer;
}

std::vector<analysis::Figure> figures(const Json& document, std::span<const Json>) {
  return analysis::motion_figures(motion_document().read(document));
}

FilesQuestion of_command() {
  FilesQuestion question;
  question.request.series = false;
  return question;
}

constexpr StudyFunctions<FilesQuestion> functions{
    .of_command = of_command, .check = check, .find = find, .figures = figures};

}  // namespace

const Study& motion_study() {
  static const Study study = study_of<FilesQuestion, functions>({
      .name = "motion",
      .sentence = "Read ground motions, and print their intensity measures",
      .example = "record.at2 --periods 0.2 0.5 1 --block 0.35 1.6 --figure out",
      .text =
          "prints what was read, peak acceleration, velocity and displacement, Arias intensity, cumulative absolute "
          "velocity, significant duration, the response spectrum, and the least scale at which the block rocks; draws "
          "the motion and its spectra into the folder out.",
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
