#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/fields/field_checker.hpp"
#include "rocking/fields/field_describer.hpp"
#include "rocking/fields/field_reader.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// Places among the names of the laws that an object gives.
std::vector<std::size_t> laws_in(const Json& object) {
  std::vector<std::size_t> given;
  for (std::size_t i = 0; i < law_names.size(); ++i) {
    if (object.contains(std::string(law_names[i]))) given.push_back(i);
  }
  return given;
}

}  // namespace

Json QuantityType::json(const void* value) const { return mean_of(*static_cast<const Quantity*>(value)); }

void QuantityType::read(const Json& json, const ReadingPlace& place, void* value) const {
  auto& quantity = *static_cast<Quantity*>(value);
  if (!json.is_object()) {
    double number = 0.0;
    number_.read(json, place, &number);
    quantity = number;
    return;
  }
  const std::vector<std::size_t> given = laws_in(json);
  FieldReader in(json, place.pointer, *place.problems);
  for (const std::string_view name : law_names) static_cast<void>(in.has(name));
  if (given.size() != 1) {
    place.reject(json, given.empty() ? "has no distribution" : "cannot have two distributions",
                 "give {\"uniform\": [a, b]}, {\"normal\": {\"mean\": m, \"sigma\": s}}, or another law: " +
                     quoted_words(law_names));
  } else {
    const std::size_t problems_before = place.problems->size();
    quantity = law_at(given.front());
    keys_of_law(in, quantity, number_.rule());
    if (place.problems->size() == problems_before) {
      if (auto refusal = refusal_of_law(quantity)) in.reject(law_names[given.front()], *std::move(refusal));
    }
    if (place.problems->size() != problems_before) quantity = 0.0;  // its numbers are no law
  }
  Json canonical = in.finish();
  if (place.canonical != nullptr) *place.canonical = std::move(canonical);
}

void QuantityType::report_missing(const ReadingPlace& place, void* value) const {
  ValueType::report_missing(place, value);
  *static_cast<Quantity*>(value) = 0.0;
}

void QuantityType::check(const void* value, const ReadingPlace& place) const {
  const auto& quantity = *static_cast<const Quantity*>(value);
  if (const auto* number = std::get_if<double>(&quantity)) return number_.check(number, place);
  const std::size_t problems_before = place.problems->size();
  Quantity law = quantity;
  FieldChecker checker(place.pointer, *place.problems);
  keys_of_law(checker, law, number_.rule());
  if (place.problems->size() != problems_before) return;
  if (auto refusal = refusal_of_law(quantity)) {
    place.problems->push_back({place.pointer + '/' + std::string(law_names[quantity.index() - 1]), "",
                               std::move(refusal->reason), std::move(refusal->remedy)});
  }
}

Json QuantityType::schema(const Rule& rule) const {
  return {{"oneOf", Json::array({number_.schema(rule), {{"$ref", "#/definitions/law"}}})}};
}

ValueType::Shown QuantityType::shown(const void* value) const {
  const double mean = mean_of(*static_cast<const Quantity*>(value));
  auto [allowed, standard] = number_.shown(&mean);
  return {.allowed = "*quantity* " + allowed, .standard = standard};
}

Json QuantityPairType::json(const void* value) const {
  const auto& [left, right] = *static_cast<const std::array<Quantity, 2>*>(value);
  return Json::array({quantity_.json(&left), quantity_.json(&right)});
}

void QuantityPairType::read(const Json& json, const ReadingPlace& place, void* value) const {
  auto& pair = *static_cast<std::array<Quantity, 2>*>(value);
  if (!json.is_array() || json.size() != 2) {
    return place.reject(json, "must be a list of two numbers: [left, right]",
                        place.pointer.ends_with("/rate_ratio") ? "give one ratio for each edge, or a number for both"
                                                               : "give one number for each edge");
  }
  Json canonical = Json::array();
  for (std::size_t i = 0; i < 2; ++i) {
    ReadingPlace of_item = place.at(std::to_string(i));
    Json written;
    of_item.canonical = &written;
    quantity_.read(json[i], of_item, &pair[i]);
    canonical.push_back(written.is_null() ? quantity_.json(&pair[i]) : std::move(written));
  }
  if (place.canonical != nullptr) *place.canonical = std::move(canonical);
}

void QuantityPairType::check(const void* value, const ReadingPlace& place) const {
  const auto& pair = *static_cast<const std::array<Quantity, 2>*>(value);
  for (std::size_t i = 0; i < 2; ++i) quantity_.check(&pair[i], place.at(std::to_string(i)));
}

Json QuantityPairType::schema(const Rule& rule) const {
  return {{"type", "array"}, {"items", quantity_.schema(rule)}, {"minItems", 2}, {"maxItems", 2}};
}

ValueType::Shown QuantityPairType::shown(const void*) const {
  const Quantity any = 0.0;
  return {.allowed = "two of " + quantity_.shown(&any).allowed, .standard = ""};
}

namespace {

void keys_of(FieldVisitor& in, BlockPart& part) {
  in.value({"width_m", "[m]"}, part.width, rules::length, Absent::error);
  in.value({"height_m", "[m]"}, part.height, rules::length, Absent::error);
  in.value({"mass_kg", "[kg]"}, part.mass, rules::mass, Absent::error);
  in.value({"x_m", "of its middle [m]"}, part.x, rules::offset, Absent::error);
  in.value({"bottom_m", "of its bottom above the floor [m]"}, part.bottom, rules::bottom, Absent::error);
}

void keys_of(FieldVisitor& in, BuildingMode& mode) {
  in.value({"frequency_hz", "[Hz]"}, mode.frequency_hz, rules::building_frequency_hz, Absent::error);
  in.value({"damping_ratio", "over critical"}, mode.damping_ratio, rules::damping_ratio, Absent::error);
  in.value({"factor", "participation factor times the shape at the floor"}, mode.factor, rules::mode_factor,
           Absent::error);
}

/// A list of objects, of a std::vector<T>.
template <class T>
class ObjectsType final : public ValueType {
 public:
  ObjectsType(std::size_t most, std::string_view what, std::string_view remedy)
      : most_(most), what_(what), remedy_(remedy) {}

  [[nodiscard]] Json json(const void*) const override { return Json::array(); }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& objects = *static_cast<std::vector<T>*>(value);
    objects.clear();
    if (!json.is_array() || json.empty() || json.size() > most_) {
      return place.reject(json, "must be a list of 1 to " + std::to_string(most_) + ' ' + what_, remedy_);
    }
    Json canonical = Json::array();
    for (std::size_t i = 0; i < json.size(); ++i) {
      FieldReader in(json[i], place.pointer + '/' + std::to_string(i), *place.problems);
      keys_of(in, objects.emplace_back());
      canonical.push_back(in.finish());
    }
    if (place.canonical != nullptr) *place.canonical = std::move(canonical);
  }
  void check(const void* value, const ReadingPlace& place) const override {
    auto objects = *static_cast<const std::vector<T>*>(value);
    if (objects.empty() || objects.size() > most_) {
      place.problems->push_back({place.pointer, std::to_string(objects.size()),
                                 "must be 1 to " + std::to_string(most_) + ' ' + what_, "give fewer, or one"});
      objects.resize(std::min(objects.size(), most_));
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
      FieldChecker checker(place.pointer + '/' + std::to_string(i), *place.problems);
      keys_of(checker, objects[i]);
    }
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    std::vector<KeyRow> rows;
    FieldDescriber describer("", rows);
    T object;
    keys_of(describer, object);
    return {{"type", "array"}, {"items", describer.schema()}, {"minItems", 1}, {"maxItems", most_}};
  }
  [[nodiscard]] Shown shown(const void*) const override { return {.allowed = "list of objects", .standard = ""}; }

 private:
  std::size_t most_;
  std::string what_, remedy_;
};

/// The modes of a Building: a list, or their number.
class ModesType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& building = *static_cast<const Building*>(value);
    return building.modes.empty() ? number_.json(&building.uniform_modes) : list_.json(&building.modes);
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& building = *static_cast<Building*>(value);
    building.modes.clear();
    if (json.is_array()) return list_.read(json, place, &building.modes);
    number_.read(json, place, &building.uniform_modes);
  }
  void check(const void* value, const ReadingPlace& place) const override {
    const auto& building = *static_cast<const Building*>(value);
    if (!building.modes.empty()) return list_.check(&building.modes, place);
    number_.check(&building.uniform_modes, place);
  }
  [[nodiscard]] Json schema(const Rule& rule) const override {
    return {{"anyOf", Json::array({number_.schema(rule), list_.schema(rule)})}};
  }
  [[nodiscard]] Shown shown(const void* value) const override {
    Shown shown = number_.shown(&static_cast<const Building*>(value)->uniform_modes);
    shown.allowed += ", or list of objects";
    return shown;
  }

 private:
  NumberType<int> number_{rules::uniform_modes};
  ObjectsType<BuildingMode> list_{
      most_building_modes, "modes",
      "give modes such as {\"frequency_hz\": 1.5, \"damping_ratio\": 0.05, \"factor\": 1.2}"};
};

}  // namespace

const ValueType& parts_type() {
  static const ObjectsType<BlockPart> type(
      most_parts, "parts",
      "give rectangles such as {\"width_m\": 0.6, \"height_m\": 1.0, \"mass_kg\": 80, \"x_m\": 0, \"bottom_m\": 0}");
  return type;
}

const ValueType& modes_type() { return the_only<ModesType>(); }

Json law_schema() {
  constexpr Rule any_number;
  Json laws = Json::array();
  for (std::size_t i = 0; i < law_names.size(); ++i) {
    std::vector<KeyRow> rows;
    FieldDescriber describer("", rows);
    Quantity law = law_at(i);
    keys_of_law(describer, law, any_number);
    laws.push_back(describer.schema());
  }
  return {{"oneOf", laws}};
}

Json FormsType::json(const void* value) const {
  const auto& formed = *static_cast<const Formed*>(value);
  const Form& form = forms_[formed.form];
  if (form.rule == nullptr) return form.name;
  Json number = mean_of(formed.value);
  if (formed.right) number = Json::array({number, mean_of(*formed.right)});
  return form.name.empty() ? number : Json{{form.name, number}};
}

void FormsType::read(const Json& json, const ReadingPlace& place, void* value) const {
  auto& formed = *static_cast<Formed*>(value);
  const auto is_word = [](const Form& form) { return form.rule == nullptr; };
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    if (!is_word(forms_[i]) || json != forms_[i].name) continue;
    formed.form = i;
    return;
  }
  formed = {.form = 0, .value = 0.0};
  if (json.is_string() && std::ranges::any_of(forms_, is_word)) {
    return place.reject(json, std::string(forms_.front().rule->demand), std::string(remedy_));
  }
  const auto is_of_object = [](const Form& form) { return form.rule != nullptr && !form.name.empty(); };
  auto of_object = std::ranges::find_if(
      forms_, [&](const Form& form) { return is_of_object(form) && json.contains(std::string(form.name)); });
  if (of_object == forms_.end()) of_object = std::ranges::find_if(forms_, is_of_object);
  if (!json.is_object() || !laws_in(json).empty() || of_object == forms_.end()) {
    return QuantityType(*forms_.front().rule).read(json, place, &formed.value);
  }
  formed.form = static_cast<std::size_t>(of_object - forms_.begin());
  FieldReader in(json, place.pointer, *place.problems);
  const Key key{of_object->name, ""};
  const auto given = json.find(of_object->name);
  if (of_object->may_differ_by_side && given != json.end() && given->is_array()) {
    std::array<Quantity, 2> pair;
    in.value(key, pair, QuantityPairType(*of_object->rule), Absent::error);
    formed.value = std::move(pair[0]);
    formed.right = std::move(pair[1]);
  } else if (of_object->may_be_drawn) {
    in.value(key, formed.value, *of_object->rule, Absent::error);
  } else {
    formed.value = in.number(key, *of_object->rule);
  }
  Json canonical = in.finish();
  if (place.canonical != nullptr) *place.canonical = std::move(canonical);
}

void FormsType::report_missing(const ReadingPlace& place, void* value) const {
  ValueType::report_missing(place, value);
  *static_cast<Formed*>(value) = {.form = 0, .value = 0.0};
}

void FormsType::check(const void* value, const ReadingPlace& place) const {
  const auto& formed = *static_cast<const Formed*>(value);
  const Form& form = forms_[formed.form];
  if (form.rule == nullptr) return;
  const ReadingPlace of_number = form.name.empty() ? place : place.at(form.name);
  if (formed.right) {
    const std::array<Quantity, 2> pair{formed.value, *formed.right};
    return QuantityPairType(*form.rule).check(&pair, of_number);
  }
  QuantityType(*form.rule).check(&formed.value, of_number);
}

std::optional<std::string> FormsType::written(std::string_view name) const {
  const std::string_view key = name.substr(0, name.find('/'));
  const auto form = std::ranges::find(forms_, key, &Form::name);
  if (key.empty() || form == forms_.end() || form->rule == nullptr) return std::nullopt;
  const Json number = Json::parse(form->rule->example);
  return Json{{key, key == name ? number : Json::array({number, number})}}.dump();
}

Json FormsType::schema(const Rule& rule) const {
  Json schema = QuantityType(*forms_.front().rule).schema(rule);
  for (const Form& form : forms_.subspan(1)) {
    const std::string name(form.name);
    if (form.rule == nullptr) {
      schema["oneOf"].push_back({{"const", name}});
      continue;
    }
    Json number = form.may_be_drawn ? QuantityType(*form.rule).schema({}) : NumberType<double>(*form.rule).schema({});
    if (form.may_differ_by_side) number["oneOf"].push_back(QuantityPairType(*form.rule).schema({}));
    schema["oneOf"].push_back(closed_object({{name, number}}, Json::array({name})));
  }
  return schema;
}

ValueType::Shown FormsType::shown(const void*) const {
  std::string allowed = "*quantity* " + interval_text(*forms_.front().rule);
  for (const Form& form : forms_.subspan(1)) {
    const std::string name(form.name);
    allowed += &form == &forms_.back() ? ", or `" : ", `";
    if (form.rule == nullptr) {
      allowed += name + '`';
    } else {
      allowed += "{\"" + name + "\": r}` with " + (form.may_be_drawn ? "*quantity* " : "") + "r in " +
                 interval_text(*form.rule) + (form.may_differ_by_side ? " or `[left, right]` of them" : "");
    }
  }
  return {.allowed = allowed, .standard = ""};
}

namespace {

/// Of a `std::optional<ResponseMode>`.
class ModeType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override { return to_string(**static_cast<const Mode*>(value)); }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    const auto mode = json.is_string() ? section::response_mode_named(json.get<std::string>()) : std::nullopt;
    const bool exists =
        mode && (mode->kind != section::ResponseKind::periodic || (mode->rocks >= 0 && mode->periods > 0));
    if (!exists) {
      return place.reject(json, "is not the name of a response mode",
                          "give " + section::response_mode_words() + ", or (m,n) such as \"(1,3)\"");
    }
    *static_cast<Mode*>(value) = mode;
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    return {{"type", "string"}, {"pattern", section::response_mode_pattern()}};
  }
  [[nodiscard]] Shown shown(const void*) const override {
    return {.allowed = "name of a response mode", .standard = ""};
  }

 private:
  using Mode = std::optional<section::ResponseMode>;
};

/// 64 bits as text or number; the canonical text has them as text.
class SeedType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return seed_text(*static_cast<const std::uint64_t*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::optional<std::uint64_t> seed;
    if (json.is_number_unsigned()) seed = json.get<std::uint64_t>();
    if (json.is_string()) seed = seed_from_text(json.get<std::string>());
    *static_cast<std::uint64_t*>(value) = seed.value_or(0);
    if (!seed) {
      place.reject(json, "must be a whole number of at most 64 bits", "give a value such as \"0x2012\" or 8210");
    }
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    return {{"oneOf", Json::array({type_of<std::uint64_t>().schema({}),
                                   {{"type", "string"}, {"pattern", "^(0[xX][0-9a-fA-F]{1,16}|[0-9]{1,20})$"}}})}};
  }
  [[nodiscard]] Shown shown(const void* value) const override {
    return {.allowed = "64 bits, as text or number",
            .standard = std::to_string(*static_cast<const std::uint64_t*>(value))};
  }
};

Json pointer_schema() {
  return {{"type", "string"}, {"pattern", "^/"}, {"description", "JSON pointer into this file"}};
}

}  // namespace

const ValueType& mode_type() { return the_only<ModeType>(); }
const ValueType& written_seed_type() { return the_only<SeedType>(); }

const ValueType& sweep_type() {
  static const OpaqueType type = [] {
    const Json number = {{"type", "number"}};
    const Json values = {{"type", "array"}, {"minItems", 1}};
    const Json stepped =
        closed_object({{"parameter", pointer_schema()}, {"from", number}, {"to", number}, {"step", number}},
                      Json::array({"parameter", "from", "to", "step"}));
    const Json listed = closed_object({{"parameter", pointer_schema()},
                                       {"values", values},
                                       {"names", {{"type", "array"}, {"items", {{"type", "string"}}}}}},
                                      Json::array({"parameter", "values"}));
    return OpaqueType({{"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", Json::array({stepped, listed})}}}},
                      "list of entries, below");
  }();
  return type;
}

const ValueType& unknown_type() {
  static const OpaqueType type = [] {
    const Json number = {{"type", "number"}};
    const Json entry = closed_object(
        {{"parameter", pointer_schema()}, {"from", number}, {"to", number}, {"prior", {{"type", "object"}}}},
        Json::array({"parameter", "from", "to"}));
    return OpaqueType({{"type", "array"}, {"minItems", 1}, {"maxItems", most_unknowns}, {"items", entry}},
                      "list of entries, below");
  }();
  return type;
}

}  // namespace rocking
