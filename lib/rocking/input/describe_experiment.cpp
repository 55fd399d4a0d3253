#include "rocking/input/read_experiment.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rocking/fields/field_describer.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

Json path_schema() { return {{"type", "string"}, {"minLength", 1}}; }
Json digest_schema() { return {{"type", "string"}, {"pattern", "^[0-9a-fA-F]{64}$"}}; }

Json positive_schema() { return {{"type", "number"}, {"exclusiveMinimum", 0}}; }

/// No files: their keys are described.
class DescribedRecords final : public RecordFields {
 public:
  [[nodiscard]] const ValueType& format_type() const override { return record_format_type(); }
  void file(FieldVisitor& in, const Key& file, const Key& digest, std::string&) override {
    in.field(file, OpaqueType(path_schema(), "path"), nullptr, Absent::omitted);
    in.field(digest, OpaqueType(digest_schema(), "SHA-256"), nullptr, Absent::omitted);
  }
  bool suite(FieldVisitor& in, const Key& key) override {
    const Json record = closed_object({{"file", path_schema()},
                                       {"sha256", digest_schema()},
                                       {"component", {{"type", "string"}, {"minLength", 1}}},
                                       {"vertical_file", path_schema()},
                                       {"vertical_sha256", digest_schema()},
                                       {"factor", positive_schema()},
                                       {"level", positive_schema()},
                                       {"return_period_years", positive_schema()},
                                       {"magnitude", {{"type", "number"}, {"minimum", 0}, {"maximum", 10}}},
                                       {"distance_km", positive_schema()}},
                                      Json::array({"file"}));
    const Json records = {
        {"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", Json::array({path_schema(), record})}}}};
    const Json levels = closed_object({{"levels", path_schema()}}, Json::array({"levels"}));
    in.field(key, OpaqueType({{"oneOf", Json::array({path_schema(), records, levels})}}, "pattern, list or table"),
             nullptr, Absent::omitted);
    in.require_one_of({"file", key.name});
    in.field({"left_out", "records of the suite that could not be read, as `run --skip-unreadable` writes them"},
             OpaqueType({{"type", "array"}, {"items", path_schema()}}, "list of paths"), nullptr, Absent::omitted);
    return true;
  }
  void ground_motion(FieldVisitor&, const GroundMotionReading&, const std::optional<Strength>&, Recorded&) override {}
};

/// Goes through all keys; returns the schema of the object that they stand in.
Json describe(std::vector<KeyRow>& rows) {
  UnsweptExperiment question;
  FieldDescriber describer("", rows);
  DescribedRecords records;
  keys_of(describer, question, records);
  return describer.schema();
}

}  // namespace

std::string experiment_schema_text() {
  std::vector<KeyRow> rows;
  const Json keys = describe(rows);
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", experiment_format},
                 {"description",
                  "A question about a rocking block: the scene, what fluctuates, what is swept, how many realisations. "
                  "Bounds that tie values to each other are checked by `rocking validate`."},
                 {"type", "object"},
                 {"properties", {{"format", {{"const", experiment_format}}}}},
                 {"required", Json::array({"format"})},
                 {"additionalProperties", false},
                 {"definitions", {{"law", law_schema()}}}};
  schema["properties"].update(keys["properties"]);
  for (const Json& key : keys["required"]) schema["required"].push_back(key);
  return schema.dump(2) + '\n';
}

std::optional<std::string> place_of_key(std::string_view key) {
  std::vector<KeyRow> rows;
  static_cast<void>(describe(rows));
  std::vector<std::string> places;
  for (const KeyRow& row : rows) {
    const std::size_t point = row.key.rfind('.');
    if (point == std::string::npos || std::string_view(row.key).substr(point + 1) != key) continue;
    const std::size_t kind = row.key.find(": ");  // of `harmonic: excitation.phase_rad`
    const std::size_t begin = kind == std::string::npos ? 0 : kind + 2;
    std::string place = '/' + row.key.substr(begin, point - begin);
    std::ranges::replace(place, '.', '/');
    if (std::ranges::find(places, place) == places.end()) places.push_back(std::move(place));
  }
  if (places.empty()) return std::nullopt;
  return places.size() == 2 ? places[0] + " or " + places[1] : places[0];
}

std::string experiment_table() {
  std::vector<KeyRow> rows;
  static_cast<void>(describe(rows));
  std::string table = "| key | value | meaning | default |\n| --- | --- | --- | --- |\n";
  for (const KeyRow& row : rows) {
    table += "| `" + row.key + "` | " + row.allowed + " | " + std::string(row.sentence) + " | " + row.standard + " |\n";
  }
  return table;
}

}  // namespace rocking
