#include "rocking/fields/struct_type.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

/// Null: an optional member on the way has no value.
void* owner_of(const Field& field, const void* outermost) {
  void* owner = const_cast<void*>(outermost);  // written to only by Field::read
  for (const InlinedMember& member : field.inlined_by) {
    if (owner != nullptr) owner = member.find(owner);
  }
  return owner;
}

}  // namespace

std::string keyword_of(const Field& field) {
  if (field.flag.names.empty() || field.flag.is_of_program) return "";
  if (!field.flag.names.starts_with("--")) return std::string(field.key);
  std::string keyword(field.flag.names.substr(2, field.flag.names.find(',') - 2));
  std::ranges::replace(keyword, '-', '_');
  return keyword;
}

std::string sentence_of_flag(const Field& field) {
  std::string sentence(field.sentence);
  if (field.flag.kind != FlagKind::off) return sentence;
  sentence.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence.front())));
  return "Do not " + sentence;
}

base::InputError with_names(const base::InputError& error, const std::vector<Field>& fields,
                            std::string (*name)(const Field& field)) {
  std::vector<base::Problem> problems = error.problems();
  for (base::Problem& problem : problems) {
    for (const Field& each : fields) {
      for (std::string* text : {&problem.reason, &problem.remedy}) {
        const std::string quoted = '`' + std::string(each.key) + '`';
        const std::size_t at = each.flag.names.empty() ? std::string::npos : text->find(quoted);
        if (at != std::string::npos) text->replace(at, quoted.size(), name(each));
      }
    }
    const std::string key = problem.place.substr(0, problem.place.find('/'));
    const auto field =
        std::ranges::find_if(fields, [&key](const Field& each) { return each.key == key && !each.flag.names.empty(); });
    if (!key.empty() && field != fields.end()) problem.place.replace(0, key.size(), name(*field));
  }
  return base::InputError(std::move(problems));
}

bool Field::may_be_absent() const {
  return without_value == WithoutValue::omitted || std::ranges::any_of(inlined_by, &InlinedMember::is_optional);
}

bool Field::is_omitted(const void* outermost) const {
  const void* owner = owner_of(*this, outermost);
  return owner == nullptr || (without_value == WithoutValue::omitted && has_value != nullptr && !has_value(owner));
}

Json Field::json(const void* outermost) const {
  void* owner = owner_of(*this, outermost);
  return member == nullptr ? derive(owner) : type->json(member(owner));
}

void Field::write(const void* outermost, JsonWriter& out) const {
  void* owner = owner_of(*this, outermost);
  if (member == nullptr) return out.member(key, derive(owner));
  type->write(member(owner), key, out);
}

void Field::read(const Json& json, const ReadingPlace& place, void* outermost) const {
  if (member != nullptr) type->read(json, place, member(owner_of(*this, outermost)));
}

void Field::check(const ReadingPlace& place, const void* outermost) const {
  void* owner = owner_of(*this, outermost);
  if (owner != nullptr && member != nullptr) type->check(member(owner), place);
}

void Field::check_fit(const Json& json, const ReadingPlace& place, const void* outermost) const {
  if (must_fit && derive(owner_of(*this, outermost)) != json) place.reject_changed(json);
}

void Field::make_owner(void* outermost) const {
  for (const InlinedMember& inlined : inlined_by) outermost = inlined.make(outermost);
}

bool Field::is_needed(const void* outermost) const {
  return without_value == WithoutValue::null && owner_of(*this, outermost) != nullptr;
}

StructType::StructType(std::string_view name, std::initializer_list<Field> fields) : name_(name) {
  for (const Field& field : fields) {
    if (!field.key.empty()) {
      fields_.push_back(field);
      continue;
    }
    for (Field inner : dynamic_cast<const StructType&>(*field.type).fields_) {
      inner.inlined_by.insert(inner.inlined_by.begin(), field.inlined_by.front());
      fields_.push_back(std::move(inner));
    }
  }
}

Json StructType::json(const void* value) const {
  Json object = Json::object();
  for (const Field& field : fields_) {
    if (!field.is_omitted(value)) object[std::string(field.key)] = field.json(value);
  }
  return object;
}

void StructType::write(const void* value, std::string_view key, JsonWriter& out) const {
  out.begin_object(key);
  write_members(value, out);
  out.end();
}

void StructType::write_element(const void* value, JsonWriter& out) const {
  out.begin_object();
  write_members(value, out);
  out.end();
}

void StructType::write_members(const void* value, JsonWriter& out) const {
  for (const Field& field : fields_) {
    if (!field.is_omitted(value)) field.write(value, out);
  }
}

void StructType::read(const Json& json, const ReadingPlace& place, void* value) const {
  if (!json.is_object()) return place.reject(json, "must be an object");
  for (const auto& item : json.items()) {
    const auto has_key = [&item](const Field& field) { return field.key == item.key(); };
    if (std::ranges::none_of(fields_, has_key)) reject_unknown(item.key(), item.value(), place);
  }
  for (const Field& field : fields_) {
    if (json.contains(std::string(field.key))) field.make_owner(value);
  }
  for (const Field& field : fields_) {
    const ReadingPlace inner = place.at(field.key, field.rule);
    const auto found = json.find(std::string(field.key));
    if (found != json.end()) {
      field.read(*found, inner, value);
    } else if (field.is_needed(value)) {
      place.at(field.key).reject(Json(), "is missing");
    }
  }
  if (!place.problems->empty()) return;
  for (const Field& field : fields_) {
    if (const auto found = json.find(std::string(field.key)); found != json.end()) {
      field.check_fit(*found, place.at(field.key), value);
    }
  }
}

void StructType::check(const void* value, const ReadingPlace& place) const {
  for (const Field& field : fields_) field.check(place.at(field.key, field.rule), value);
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
    if (!field.may_be_absent()) required.push_back(field.key);
  }
  return {{"title", name_},
          {"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

void StructType::describe(const std::string& prefix, std::vector<KeyRow>& rows) const {
  for (const Field& field : fields_) {
    const std::string key = (prefix.empty() ? "" : prefix + '.') + std::string(field.key);
    rows.push_back({.key = key, .sentence = field.sentence});
    field.type->describe(key, rows);
  }
}

}  // namespace rocking
