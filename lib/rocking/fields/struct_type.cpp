#include "rocking/fields/struct_type.hpp"

#include <algorithm>
#include <utility>

#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

void* owner_of(const std::vector<void* (*)(void*)>& path, void* outermost) {
  for (void* (*const member)(void*) : path) outermost = member(outermost);
  return outermost;
}

}  // namespace

Field Field::as(const ValueType& other) const {
  Field changed = *this;
  changed.type = &other;
  return changed;
}

std::optional<Json> Field::json(const void* outermost) const {
  void* owner = owner_of(inlined_by, const_cast<void*>(outermost));  // only read through
  if (without_value == WithoutValue::omitted && has_value != nullptr && !has_value(owner)) return std::nullopt;
  return member == nullptr ? derive(owner) : type->json(member(owner));
}

void Field::read(const Json& json, const ReadingPlace& place, void* outermost) const {
  if (member != nullptr) type->read(json, place, member(owner_of(inlined_by, outermost)));
}

StructType::StructType(std::initializer_list<Field> fields) {
  for (const Field& field : fields) {
    if (!field.key.empty()) {
      fields_.push_back(field);
      continue;
    }
    for (Field inner : dynamic_cast<const StructType&>(*field.type).fields_) {
      inner.inlined_by.insert(inner.inlined_by.begin(), field.member);
      fields_.push_back(std::move(inner));
    }
  }
}

Json StructType::json(const void* value) const {
  Json object = Json::object();
  for (const Field& field : fields_) {
    if (auto json = field.json(value)) object[std::string(field.key)] = *std::move(json);
  }
  return object;
}

void StructType::read(const Json& json, const ReadingPlace& place, void* value) const {
  if (!json.is_object()) return place.reject(json, "must be an object");
  for (const auto& item : json.items()) {
    const auto has_key = [&item](const Field& field) { return field.key == item.key(); };
    if (std::ranges::none_of(fields_, has_key)) reject_unknown(item.key(), item.value(), place);
  }
  for (const Field& field : fields_) {
    ReadingPlace inner = place.at(field.key);
    inner.rule = field.rule;
    const auto found = json.find(std::string(field.key));
    if (found == json.end()) {
      if (field.without_value == WithoutValue::null) place.at(field.key).reject(Json(), "is missing");
    } else {
      field.read(*found, inner, value);
    }
  }
}

void StructType::reject_unknown(const std::string& key, const Json& value, const ReadingPlace& place) const {
  std::vector<std::string> keys;
  for (const Field& field : fields_) keys.emplace_back(field.key);
  const auto meant = nearest_word(key, keys);
  place.at(key).reject(value, "is not a known key", meant ? "did you mean \"" + *meant + "\"?" : "");
}

Json StructType::schema(const Rule&) const {
  Json properties = Json::object();
  Json required = Json::array();
  for (const Field& field : fields_) {
    Json& property = properties[std::string(field.key)] = field.type->schema(field.rule);
    property["description"] = field.sentence;
    if (field.without_value == WithoutValue::null) required.push_back(field.key);
  }
  return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

void StructType::describe(const std::string& prefix, std::vector<KeyRow>& rows) const {
  for (const Field& field : fields_) {
    const std::string key = (prefix.empty() ? "" : prefix + '.') + std::string(field.key);
    rows.push_back({.key = key, .sentence = field.sentence});
    field.type->describe(key, rows);
  }
}

}  // namespace rocking
