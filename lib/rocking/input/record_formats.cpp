#include "rocking/input/record_formats.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rocking/fields/written_types.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/other_files.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_header_lines = 100;

}  // namespace

namespace {

class RecordFormatType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& format = *static_cast<const std::optional<RecordFormat>*>(value);
    return record_format_choices[format ? static_cast<std::size_t>(*format) : automatic_record_format];
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::size_t chosen = automatic_record_format;
    choice.read(json, place, &chosen);
    if (chosen != automatic_record_format) {
      *static_cast<std::optional<RecordFormat>*>(value) = static_cast<RecordFormat>(chosen);
    } else if (place.canonical != nullptr) {
      *place.canonical = Json(Json::value_t::discarded);
    }
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return choice.schema(rule); }
  [[nodiscard]] Shown shown(const void*) const override { return choice.shown(&automatic_record_format); }

 private:
  NamesType<std::size_t> choice{record_format_choices};
};

}  // namespace

const ValueType& record_format_type() { return the_only<RecordFormatType>(); }

RecordFormat recognised_format(std::string_view text) {
  text = without_byte_order_mark(text);
  for (std::size_t i = 0; i < most_header_lines && !text.empty(); ++i) {
    std::string_view line = take_line(text);
    line = line.substr(0, line.find('#'));
    for (const RecordReader& reader : record_readers) {
      if (reader.is_line == nullptr || !reader.is_line(line)) continue;
      return static_cast<RecordFormat>(&reader - record_readers.data());
    }
  }
  return RecordFormat::columns;
}

namespace {

/// Of a file with one component, which is not chosen among several.
void check_component(const GroundMotion& motion, const GroundMotionReading& how, Problems& problems) {
  if (how.component.empty() || !motion.components.empty() || is_same_component(how.component, motion.component)) return;
  problems.push_back({how.name, brief(Json(how.component)),
                      motion.component.empty() ? "is asked for, but the file does not name its component"
                                               : "is asked for, but the file holds the component " + motion.component,
                      "omit \"component\", which is for files with several"});
}

}  // namespace

std::optional<GroundMotion> read_ground_motion(std::string_view text, const GroundMotionReading& how,
                                               Problems& problems) {
  std::optional<Refusal> refusal = refuse_binary_file(text);
  if (!refusal && !how.format && how.columns.empty()) refusal = refuse_text_format(without_byte_order_mark(text));
  if (refusal) {
    problems.push_back({how.name, "", std::move(refusal->reason), std::move(refusal->remedy)});
    return std::nullopt;
  }
  const RecordFormat format = how.format ? *how.format : recognised_format(text);
  const RecordReader& reader = record_readers[static_cast<std::size_t>(format)];
  if (format != RecordFormat::columns && !how.columns.empty()) {
    problems.push_back({how.name, "",
                        "has the format " + std::string(reader.name) + ", in which \"columns\" has no meaning",
                        "omit \"columns\"; if it is a file of numbers, give \"format\": \"columns\" and \"units\""});
    return std::nullopt;
  }
  const std::size_t problems_before = problems.size();
  auto motion = reader.read(text, how, problems);
  if (motion) check_component(*motion, how, problems);
  if (problems.size() > problems_before && !how.format && format != RecordFormat::columns) {
    problems[problems_before].reason += "; it was read as " + std::string(reader.name);
  }
  if (problems.size() > problems_before) return std::nullopt;
  motion->name = how.name;
  motion->format = reader.name;
  return motion;
}

bool add_vertical(const GroundMotion& vertical, GroundMotion& motion, Problems& problems) {
  const auto refuse = [&problems, &vertical](std::string reason, std::string remedy) {
    problems.push_back({vertical.name, "", std::move(reason), std::move(remedy)});
    return false;
  };
  if (motion.has_vertical || vertical.has_vertical) {
    return refuse("is a file of the vertical component, but one of the two files has a vertical column",
                  "omit \"vertical_file\", or give files with one component");
  }
  const std::size_t common = std::min(motion.samples.size(), vertical.samples.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (motion.samples[i].time == vertical.samples[i].time) continue;
    return refuse("has other times than " + motion.name + " from sample " + std::to_string(i + 1) + " on",
                  "give components of one record, with the same time step");
  }
  if (motion.samples.size() != vertical.samples.size()) {
    motion.warnings.push_back("contains " + std::to_string(motion.samples.size()) +
                              " samples, its vertical component " + vertical.name + ' ' +
                              std::to_string(vertical.samples.size()) + "; the shorter one is at rest from its end on");
  }
  for (const std::string& warning : vertical.warnings) motion.warnings.push_back(vertical.name + ": " + warning);
  for (std::size_t i = common; i < vertical.samples.size(); ++i) {
    motion.samples.push_back({.time = vertical.samples[i].time, .horizontal = 0.0, .vertical = 0.0});
  }
  for (std::size_t i = 0; i < vertical.samples.size(); ++i) motion.samples[i].vertical = vertical.samples[i].horizontal;
  motion.has_vertical = true;
  motion.vertical_file = vertical.name;
  return true;
}

}  // namespace rocking
