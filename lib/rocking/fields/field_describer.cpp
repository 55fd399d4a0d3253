#include "rocking/fields/field_describer.hpp"

namespace rocking {

Json closed_object(Json properties, Json required) {
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

Json FieldDescriber::schema() const {
  if (!kinds_.empty()) return {{"oneOf", kinds_}};
  Json schema = closed_object(properties_, required_);
  if (!conditions_.empty()) schema["allOf"] = conditions_;
  return schema;
}

void FieldDescriber::field(const Key& key, const ValueType& type, void* value, Absent absent) {
  auto [allowed, standard] = type.shown(value);
  Json schema = type.schema({});
  if (absent == Absent::standard && !standard.empty()) schema["default"] = type.json(value);
  schema["description"] = key.sentence;
  if (absent == Absent::error) standard = "required";
  if (absent == Absent::omitted) standard.clear();
  rows_.push_back({.key = prefix_ + std::string(key.name),
                   .sentence = key.sentence,
                   .allowed = std::move(allowed),
                   .standard = std::move(standard)});
  set(key.name, std::move(schema), absent);
}

bool FieldDescriber::one_of(std::span<const Alternative> keys, std::size_t&, void* value, Absent absent) {
  Json required = Json::array();
  for (const Alternative& each : keys) {
    const bool is_standard = absent == Absent::standard && &each == keys.data();
    field(each.key, *each.type, value, is_standard ? absent : Absent::omitted);
    required.push_back({{"required", Json::array({each.key.name})}});
  }
  if (absent == Absent::error) conditions_.push_back({{"oneOf", required}});
  return false;
}

void FieldDescriber::object(const Key& key, Absent absent, const Part& part) {
  const std::string place = prefix_ + std::string(key.name);
  rows_.push_back({.key = place,
                   .sentence = key.sentence,
                   .allowed = "object",
                   .standard = absent == Absent::error ? "required" : ""});
  FieldDescriber inner(place + '.', rows_);
  part(inner);
  Json schema = inner.schema();
  schema["description"] = key.sentence;
  set(key.name, std::move(schema), absent);
}

void FieldDescriber::value_or_object(const Key& key, bool, const Part& value, const Part& with_more) {
  FieldDescriber alone(prefix_, rows_);
  value(alone);
  FieldDescriber more(prefix_ + std::string(key.name) + '.', rows_);
  with_more(more);
  set(key.name,
      {{"description", key.sentence},
       {"oneOf", Json::array({alone.properties_[std::string(key.name)], more.schema()})}},
      Absent::standard);
}

void FieldDescriber::kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
                           const std::function<void(FieldVisitor&, std::size_t)>& part) {
  const auto [allowed, standard] = NamesType<std::size_t>(names).shown(&kind);
  rows_.push_back(
      {.key = prefix_ + std::string(key.name), .sentence = key.sentence, .allowed = allowed, .standard = standard});
  for (std::size_t i = 0; i < names.size(); ++i) {
    FieldDescriber of_kind(std::string(names[i]) + ": " + prefix_, rows_);
    of_kind.set(key.name, {{"const", names[i]}}, i == kind ? Absent::standard : Absent::error);
    part(of_kind, i);
    kinds_.push_back(of_kind.schema());
  }
}

void FieldDescriber::exclude(std::string_view key, std::string_view other, Refusal) {
  conditions_.push_back({{"not", {{"required", Json::array({key, other})}}}});
}

void FieldDescriber::require_one_of(std::initializer_list<std::string_view> keys) {
  Json required = Json::array();
  for (const std::string_view key : keys) required.push_back({{"required", Json::array({key})}});
  conditions_.push_back({{"oneOf", required}});
}

void FieldDescriber::set(std::string_view key, Json schema, Absent absent) {
  properties_[std::string(key)] = std::move(schema);
  if (absent == Absent::error) required_.push_back(key);
}

}  // namespace rocking
