#include "rocking/api/studies.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/base/error.hpp"
#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/output/motion_report.hpp"
#include "rocking/scene/number_rule.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

/// The one of this name.
template <class Enumeration, std::size_t count>
Enumeration named(std::string_view place, const std::array<std::string_view, count>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse(place, name, "is unknown");
  return static_cast<Enumeration>(found - names.begin());
}

void check(const GroundMotionRequest& request) {
  if (request.format == "columns" && !request.units) {
    refuse("units", "",
           "is missing: columns do not state the unit of the accelerations; give " + record_units_in_words());
  }
  if (request.vertical && request.files.size() > 1) {
    refuse("vertical", *request.vertical, "belongs to one file, of which there are more");
  }
  if (request.time_step && !(*request.time_step > 0.0)) {
    refuse("time_step", std::to_string(*request.time_step), "must be positive");
  }
  const MotionQuestion& question = request.question;
  if (!(question.damping >= 0.0 && question.damping < 1.0)) {
    refuse("damping", std::to_string(question.damping), "must be at least 0 and below 1");
  }
  if (!(question.gravity > 0.0)) refuse("gravity", std::to_string(question.gravity), "must be positive");
  for (const double period : question.periods) {
    if (!(period > 0.0)) refuse("periods", std::to_string(period), "must be positive");
  }
  if (!question.block) return;
  for (const double length : {question.block->width, question.block->height}) {
    if (!rules::length.allows(length)) refuse("block", std::to_string(length), std::string(rules::length.demand));
  }
}

}  // namespace

std::vector<MeasuredMotion> motion(const GroundMotionRequest& request) {
  check(request);
  GroundMotionReading how{.time_step = request.time_step,
                          .gravity = request.question.gravity,
                          .vertical_name = request.vertical.value_or("")};
  if (request.format != "auto") how.format = named<RecordFormat>("format", record_format_choices, request.format);
  for (const std::string& column : request.columns) {
    how.columns.push_back(named<RecordColumn>("columns", record_column_names, column));
  }
  if (!how.columns.empty()) {
    if (const auto refusal = refuse_columns(how.columns, how.time_step.has_value())) {
      refuse("columns", "", refusal->reason + "; " + refusal->remedy);
    }
  }
  if (request.units) how.unit = named<RecordUnit>("units", record_unit_names, *request.units);
  GroundMotionFiles files(files_seen_from(""));
  Problems problems;
  std::vector<MeasuredMotion> motions;
  for (const std::string& file : request.files) {
    how.name = file;
    auto read = files.motion(how, problems);
    if (read) motions.push_back(measured(std::move(read), files.digest(file), request.question));
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return motions;
}

std::string motion_text(const GroundMotionRequest& request, const std::vector<MeasuredMotion>& found) {
  const MotionDetail detail = request.series ? MotionDetail::series : MotionDetail::measures;
  return motion_document().text(motion_report(found, request.question, detail));
}

}  // namespace rocking
