#include "rocking/input/read_experiment.hpp"

#include <utility>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/fields/value_type.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/keys.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// A row of the table of keys.
struct ExperimentKeyRow {
  std::string key;  ///< as `block.width_m`
  std::string allowed;
  std::string meaning;
  std::string standard;
};

Json closed_object(Json properties, Json required) {
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

Rule bounds_of(const IntegerRule& rule) {
  return {.least = static_cast<double>(rule.low), .most = static_cast<double>(rule.high)};
}

Json number_schema(const NumberRule& rule) { return type_of<double>().schema(rule.bounds); }

/// A number, or one of the laws from which it is drawn once.
Json quantity_schema(const NumberRule& rule) {
  return {{"oneOf", Json::array({number_schema(rule), {{"$ref", "#/definitions/law"}}})}};
}

Json words_schema(std::span<const std::string_view> names) {
  Json words = Json::array();
  for (const std::string_view name : names) words.push_back(name);
  return {{"enum", words}};
}

/// `[1e-06, 1e+06]`, with round brackets at ends that do not belong to it.
std::string interval(const Rule& bounds) {
  return (bounds.least ? '[' + base::shortest(*bounds.least) : '(' + base::shortest(*bounds.above)) + ", " +
         (bounds.most ? base::shortest(*bounds.most) + ']' : base::shortest(*bounds.below) + ')');
}

std::string in_code(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "`" : ", `") + std::string(name) + '`';
  return list;
}

class DescribingKeys final : public Keys {
 public:
  /// `prefix`: of the keys in the table.
  DescribingKeys(std::string prefix, std::vector<ExperimentKeyRow>& rows) : prefix_(std::move(prefix)), rows_(rows) {}

  [[nodiscard]] Json schema() const {
    if (!kinds_.empty()) return {{"oneOf", kinds_}};
    Json schema = closed_object(properties_, required_);
    if (!conditions_.empty()) schema["allOf"] = conditions_;
    return schema;
  }

  void text(const Key& key, std::string& value) override {
    add(key, {{"type", "string"}, {"default", value}}, "text", Absent::standard, "\"" + value + '"');
  }
  void number(const Key& key, double& value, const NumberRule& rule, Absent absent) override {
    add(key, with_default(number_schema(rule), value, absent), interval(rule.bounds), absent, base::shortest(value));
  }
  void whole_number(const Key& key, std::int64_t& value, const IntegerRule& rule, Absent absent) override {
    add(key, with_default(type_of<std::int64_t>().schema(bounds_of(rule)), value, absent),
        "integer, " + std::to_string(rule.low) + " to " + std::to_string(rule.high), absent, std::to_string(value));
  }
  void numbers(const Key& key, std::vector<double>&, const ListLength& length, const NumberRule& rule,
               Absent absent) override {
    add(key, {{"type", "array"}, {"items", number_schema(rule)}, {"minItems", length.least}, {"maxItems", length.most}},
        "list", absent, "");
  }
  void quantity(const Key& key, Quantity& value, const NumberRule& rule, Absent absent) override {
    add(key, with_default(quantity_schema(rule), std::get<double>(value), absent),
        "*quantity* " + interval(rule.bounds), absent, base::shortest(std::get<double>(value)));
  }
  void word(const Key& key, std::size_t& chosen, std::span<const std::string_view> names, Absent absent) override {
    add(key, with_default(words_schema(names), names[chosen], absent), in_code(names), absent,
        '`' + std::string(names[chosen]) + '`');
  }
  void words(const Key& key, std::vector<std::size_t>&, std::span<const std::string_view> names) override {
    add(key, {{"type", "array"}, {"items", words_schema(names)}, {"minItems", 1}}, "list of " + in_code(names),
        Absent::omitted, "");
  }
  void forms(const Key& key, Formed&, std::span<const Form> forms, std::string_view, Absent absent) override {
    Json schema = quantity_schema(*forms.front().rule);
    std::string allowed = "*quantity* " + interval(forms.front().rule->bounds);
    for (const Form& form : forms.subspan(1)) {
      const std::string name(form.name);
      allowed += &form == &forms.back() ? ", or `" : ", `";
      if (form.rule == nullptr) {
        schema["oneOf"].push_back({{"const", name}});
        allowed += name + '`';
        continue;
      }
      const Json number = form.may_be_drawn ? quantity_schema(*form.rule) : number_schema(*form.rule);
      schema["oneOf"].push_back(closed_object({{name, number}}, Json::array({name})));
      allowed += "{\"" + name + "\": r}` with " + (form.may_be_drawn ? "*quantity* " : "") + "r in " +
                 interval(form.rule->bounds);
    }
    add(key, std::move(schema), allowed, absent, "");
  }
  void mode(const Key& key, std::optional<section::ResponseMode>&) override {
    add(key, {{"type", "string"}, {"pattern", section::response_mode_pattern()}}, "name of a response mode",
        Absent::omitted, "");
  }
  void seed(const Key& key, std::uint64_t& value) override {
    add(key,
        {{"oneOf", Json::array({type_of<std::uint64_t>().schema({}),
                                {{"type", "string"}, {"pattern", "^(0[xX][0-9a-fA-F]{1,16}|[0-9]{1,20})$"}}})}},
        "64 bits, as text or number", Absent::standard, std::to_string(value));
  }
  void sweep(const Key& key) override {
    const Json pointer = {{"type", "string"}, {"pattern", "^/"}, {"description", "JSON pointer into this file"}};
    const Json number = {{"type", "number"}};
    const Json values = {{"type", "array"}, {"minItems", 1}};
    const Json stepped = closed_object({{"parameter", pointer}, {"from", number}, {"to", number}, {"step", number}},
                                       Json::array({"parameter", "from", "to", "step"}));
    const Json listed =
        closed_object({{"parameter", pointer}, {"values", values}}, Json::array({"parameter", "values"}));
    add(key, {{"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", Json::array({stepped, listed})}}}},
        "list of entries, below", Absent::omitted, "");
  }
  void unknowns(const Key& key) override {
    const Json pointer = {{"type", "string"}, {"pattern", "^/"}, {"description", "JSON pointer into this file"}};
    const Json number = {{"type", "number"}};
    const Json entry =
        closed_object({{"parameter", pointer}, {"from", number}, {"to", number}, {"prior", {{"type", "object"}}}},
                      Json::array({"parameter", "from", "to"}));
    add(key, {{"type", "array"}, {"minItems", 1}, {"maxItems", most_unknowns}, {"items", entry}},
        "list of entries, below", Absent::omitted, "");
  }
  void scatter(std::initializer_list<Scatter>) override {
    Key sigma{"sigma", "standard deviation, in the unit in which the mean is given; or relative_sigma"};
    Key relative{"relative_sigma", "in place of sigma: over the absolute value of the mean"};
    for (const Key& key : {sigma, relative}) {
      add(key, number_schema(rules::sigma), interval(rules::sigma.bounds), Absent::omitted, "");
    }
    require_one_of({sigma.name, relative.name});
  }
  bool one_of(std::span<const UnitKey> units, QuantityInUnit& value, Absent absent) override {
    Json required = Json::array();
    for (const UnitKey& unit : units) {
      const bool is_standard = absent == Absent::standard && &unit == units.data();
      const double standard = mean_of(value.value);
      add(unit.key, with_default(quantity_schema(unit.rule), standard, is_standard ? absent : Absent::omitted),
          "*quantity* " + interval(unit.rule.bounds), is_standard ? absent : Absent::omitted, base::shortest(standard));
      required.push_back({{"required", Json::array({unit.key.name})}});
    }
    if (absent == Absent::error) conditions_.push_back({{"oneOf", required}});
    return false;
  }
  void record_format(const Key& key, std::optional<RecordFormat>&) override {
    std::size_t chosen = automatic_record_format;
    word(key, chosen, record_format_choices, Absent::standard);
  }
  void file(const Key& file, const Key& digest, std::string&) override {
    add(file, {{"type", "string"}, {"minLength", 1}}, "path", Absent::omitted, "");
    add(digest, {{"type", "string"}, {"pattern", "^[0-9a-fA-F]{64}$"}}, "SHA-256", Absent::omitted, "");
  }
  bool suite(const Key& key) override {
    const Json path = {{"type", "string"}, {"minLength", 1}};
    const Json digest = {{"type", "string"}, {"pattern", "^[0-9a-fA-F]{64}$"}};
    const Json record =
        closed_object({{"file", path}, {"sha256", digest}, {"vertical_file", path}, {"vertical_sha256", digest}},
                      Json::array({"file"}));
    const Json records = {{"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", Json::array({path, record})}}}};
    add(key, {{"oneOf", Json::array({path, records})}}, "pattern or list", Absent::omitted, "");
    require_one_of({"file", key.name});
    add({"left_out", "records of the suite that could not be read, as `run --skip-unreadable` writes them"},
        {{"type", "array"}, {"items", path}}, "list of paths", Absent::omitted, "");
    return true;
  }
  void ground_motion(const GroundMotionReading&, const std::optional<Strength>&, Recorded&) override {}

  void object(const Key& key, Absent absent, const Part& part) override {
    rows_.push_back({prefix_ + std::string(key.name), "object", std::string(key.sentence), standard_text(absent, "")});
    DescribingKeys inner(prefix_ + std::string(key.name) + '.', rows_);
    part(inner);
    Json schema = inner.schema();
    schema["description"] = key.sentence;
    set(key.name, std::move(schema), absent);
  }
  void number_or_object(const Key& key, bool, const Part& number, const Part& with_more) override {
    DescribingKeys alone(prefix_, rows_);
    number(alone);
    DescribingKeys more(prefix_ + std::string(key.name) + '.', rows_);
    with_more(more);
    set(key.name,
        {{"description", key.sentence},
         {"oneOf", Json::array({alone.properties_[std::string(key.name)], more.schema()})}},
        Absent::standard);
  }
  void kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
             const std::function<void(Keys&, std::size_t)>& part) override {
    rows_.push_back({prefix_ + std::string(key.name), in_code(names), std::string(key.sentence),
                     '`' + std::string(names[kind]) + '`'});
    for (std::size_t i = 0; i < names.size(); ++i) {
      DescribingKeys of_kind(std::string(names[i]) + ": " + prefix_, rows_);
      of_kind.set(key.name, {{"const", names[i]}}, i == kind ? Absent::standard : Absent::error);
      part(of_kind, i);
      kinds_.push_back(of_kind.schema());
    }
  }

  bool stands(std::string_view, bool) override { return true; }
  void exclude(std::string_view key, std::string_view other, Refusal) override {
    conditions_.push_back({{"not", {{"required", Json::array({key, other})}}}});
  }

 private:
  template <class T>
  static Json with_default(Json schema, const T& value, Absent absent) {
    if (absent == Absent::standard) schema["default"] = value;
    return schema;
  }

  static std::string standard_text(Absent absent, const std::string& standard) {
    switch (absent) {
      case Absent::error: return "required";
      case Absent::standard: return standard;
      case Absent::omitted: break;
    }
    return "";
  }

  void add(const Key& key, Json schema, const std::string& allowed, Absent absent, const std::string& standard) {
    rows_.push_back(
        {prefix_ + std::string(key.name), allowed, std::string(key.sentence), standard_text(absent, standard)});
    schema["description"] = key.sentence;
    set(key.name, std::move(schema), absent);
  }

  void set(std::string_view key, Json schema, Absent absent) {
    properties_[std::string(key)] = std::move(schema);
    if (absent == Absent::error) required_.push_back(key);
  }

  void require_one_of(std::initializer_list<std::string_view> keys) {
    Json required = Json::array();
    for (const std::string_view key : keys) required.push_back({{"required", Json::array({key})}});
    conditions_.push_back({{"oneOf", required}});
  }

  std::string prefix_;
  std::vector<ExperimentKeyRow>& rows_;
  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json conditions_ = Json::array();  ///< on which keys stand together
  Json kinds_ = Json::array();       ///< the whole object for each kind
};

/// Any of the laws, whatever its numbers.
Json law_schema() {
  constexpr NumberRule any_number{.bounds = {}, .demand = "", .example = ""};
  Json laws = Json::array();
  for (std::size_t i = 0; i < law_names.size(); ++i) {
    std::vector<ExperimentKeyRow> rows;
    DescribingKeys keys("", rows);
    Quantity law = law_at(i);
    keys_of_law(keys, law, any_number);
    laws.push_back(keys.schema());
  }
  return {{"oneOf", laws}};
}

/// Goes through all keys; returns the schema of the object that they stand in.
Json describe(std::vector<ExperimentKeyRow>& rows) {
  Question question;
  DescribingKeys keys("", rows);
  keys_of(keys, question);
  return keys.schema();
}

}  // namespace

std::string experiment_schema_text() {
  std::vector<ExperimentKeyRow> rows;
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

std::string experiment_table() {
  std::vector<ExperimentKeyRow> rows;
  static_cast<void>(describe(rows));
  std::string table = "| key | value | meaning | default |\n| --- | --- | --- | --- |\n";
  for (const ExperimentKeyRow& row : rows) {
    table += "| `" + row.key + "` | " + row.allowed + " | " + row.meaning + " | " + row.standard + " |\n";
  }
  return table;
}

}  // namespace rocking
