#include "rocking/fields/field_reader.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_unknown_keys = 10;

const Json& no_keys() {
  static const Json empty = Json::object();
  return empty;
}

std::string correction(const std::string& written, std::span<const std::string_view> known_keys) {
  std::vector<std::string> known;  // each once: some keys are asked for twice
  for (const std::string_view key : known_keys) {
    if (std::ranges::find(known, key) == known.end()) known.emplace_back(key);
  }
  if (const auto nearest = nearest_word(written, known)) return "did you mean \"" + *nearest + "\"?";
  if (known.empty()) return "remove it";
  std::string list = "known keys: ";
  for (const std::string& key : known) list += (&key == &known.front() ? "\"" : ", \"") + key + '"';
  return list;
}

}  // namespace

bool is_within(std::string_view inner, std::string_view outer) {
  return inner == outer || (inner.starts_with(outer) && inner[outer.size()] == '/');
}

FieldReader::FieldReader(const Json& source, std::string place, Problems& problems)
    : FieldVisitor(&problems, true), source_(&source), place_(std::move(place)) {
  known_.reserve(32);
  if (source.is_object()) return;
  problems.push_back({place_.empty() ? "the file" : place_, brief(source),
                      "must be an object, not " + std::string(kind_name(source)), "write it as { \"key\": value }"});
  source_ = &no_keys();
  problems_ = &ignored_;
}

const Json* FieldReader::found(std::string_view key) {
  known_.push_back(key);
  const auto found = source_->find(key);
  return found == source_->end() ? nullptr : &*found;
}

bool FieldReader::is_written(std::string_view key) const {
  return writes_ && (written_.empty() || std::ranges::find(written_, key) != written_.end());
}

void FieldReader::write(std::string_view key, Json canonical) {
  if (is_written(key)) canonical_[std::string(key)] = std::move(canonical);
}

void FieldReader::field(const Key& key, const ValueType& type, void* value, Absent absent) {
  const Json* json = found(key.name);
  if (json == nullptr && absent == Absent::omitted) return;
  if (json == nullptr && absent == Absent::standard) {
    if (is_written(key.name)) write(key.name, type.json(value));
    return;
  }
  Json canonical;
  const ReadingPlace place{
      .pointer = place_of(key.name), .problems = problems_, .sentence = key.sentence, .canonical = &canonical};
  if (json == nullptr) return type.report_missing(place, value);
  const std::size_t problems_before = problem_count();
  type.read(*json, place, value);
  if (canonical.is_discarded() || !is_written(key.name)) return;
  if (canonical.is_null() && problem_count() == problems_before) canonical = type.json(value);
  if (!canonical.is_null()) write(key.name, std::move(canonical));
}

double FieldReader::number(const Key& key, const Rule& rule) {
  double number = 0.0;
  value(key, number, rule, Absent::error);
  return number;
}

bool FieldReader::one_of(std::span<const Alternative> keys, std::size_t& chosen, void* value, Absent absent) {
  const std::size_t problems_before = problem_count();
  std::optional<std::size_t> given;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string_view key = keys[i].key.name;
    if (!has(key)) continue;
    if (given) {
      reject(key, {"excludes \"" + std::string(keys[*given].key.name) + '"', "keep one of them"});
    } else {
      given = i;
    }
  }
  if (!given && absent == Absent::error) {
    std::string remedy = "add ";
    for (const Alternative& each : keys) {
      if (&each != keys.data()) remedy += ", or ";
      remedy += '"' + std::string(each.key.name) + "\": " + each.type->example();
    }
    reject(keys.front().key.name, {"is missing", std::move(remedy)});
    return false;
  }
  chosen = given.value_or(0);
  field(keys[chosen].key, *keys[chosen].type, value, absent);
  return problem_count() == problems_before;
}

void FieldReader::object(const Key& key, Absent, const Part& part) {
  const Json* source = found(key.name);
  FieldReader inner(source == nullptr ? no_keys() : *source, place_of(key.name), *problems_);
  inner.writes_ = is_written(key.name);
  inner.swept_ = swept_;
  part(inner);
  write(key.name, inner.finish());
}

void FieldReader::value_or_object(const Key& key, bool, const Part& value, const Part& with_more) {
  const Json* json = found(key.name);
  if (json == nullptr || !json->is_object()) return value(*this);
  object(key, Absent::standard, with_more);
}

void FieldReader::kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
                        const std::function<void(FieldVisitor&, std::size_t)>& part) {
  const std::size_t problems_before = problem_count();
  choice(key, kind, names, Absent::standard);
  if (problem_count() != problems_before) return ignore_others();
  part(*this, kind);
}

Absent FieldReader::follows_from(std::span<const std::string_view> places) const {
  const bool swept = std::ranges::any_of(places, [this](std::string_view place) {
    return std::ranges::any_of(
        swept_, [place](const std::string& pointer) { return is_within(pointer, place) || is_within(place, pointer); });
  });
  return swept ? Absent::omitted : Absent::standard;
}

void FieldReader::exclude(std::string_view key, std::string_view other, Refusal refusal) {
  if (has(other)) reject(key, std::move(refusal));
}

void FieldReader::reject(std::string_view key, Refusal refusal) {
  const Json* json = key.empty() ? source_ : found(key);
  const bool is_nothing = json == nullptr || json == &no_keys();
  problems_->push_back({key.empty() ? place_ : place_of(key), is_nothing ? "" : brief(*json), std::move(refusal.reason),
                        std::move(refusal.remedy)});
}

void FieldReader::ignore_others() { source_ = &no_keys(); }

Json FieldReader::finish() {
  std::size_t unknown = 0;
  for (const auto& [key, json] : source_->items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    if (++unknown > most_unknown_keys) continue;
    problems_->push_back({place_of(key), brief(json), "is not a key of this format", correction(key, known_)});
  }
  if (unknown > most_unknown_keys) {
    problems_->push_back(
        {place_.empty() ? "the file" : place_, "",
         "contains " + std::to_string(unknown - most_unknown_keys) + " more keys that are not of this format",
         "see `rocking schema`"});
  }
  return std::move(canonical_);
}

}  // namespace rocking
