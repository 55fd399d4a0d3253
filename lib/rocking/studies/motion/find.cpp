#include "rocking/studies/motion/study.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/scene/number_rule.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/studies/motion/result.hpp"
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

}  // namespace

std::vector<MeasuredMotion> motion(const GroundMotionRequest& request) {
  check(request);
  GroundMotionReading how{.time_step = request.time_step,
                          .gravity = request.question.gravity,
                          .vertical_name = request.vertical.value_or("")};
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
