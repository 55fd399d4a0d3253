#include "rocking/fields/value_type.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

/// Every number with a fraction that rocking writes is smaller. Larger ones overflow the axes of figures.
constexpr double largest_number = 1e18;

void add_rule(const Rule& rule, Json& schema) {
  if (rule.least) schema["minimum"] = *rule.least;
  if (rule.above) schema["exclusiveMinimum"] = *rule.above;
  if (rule.most) schema["maximum"] = *rule.most;
  if (rule.below) schema["exclusiveMaximum"] = *rule.below;
  for (const std::string_view choice : rule.choices) schema["enum"].push_back(choice);
}

/// Whole numbers without an exponent.
std::string plain(double number) {
  constexpr double largest = 1e15;  // below 2^53
  const bool is_whole = std::abs(number) <= largest && number == std::floor(number);
  return is_whole ? std::to_string(static_cast<std::int64_t>(number)) : base::shortest(number);
}

std::string in_words(const Rule& rule) {
  std::string words = bounds_in_words(rule);
  for (const std::string_view choice : rule.choices) words += (words.empty() ? "" : ", ") + std::string(choice);
  return (rule.choices.empty() ? "must be " : "must be one of ") + words;
}

/// Numbers, texts, true and false.
template <class T>
class SimpleType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const T& written = *static_cast<const T*>(value);
    if constexpr (std::is_same_v<T, double>) ROCKING_EXPECT(std::isfinite(written));
    return written;
  }

  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    if (!fits(json)) return place.reject(json, std::string("must be ") + kind);
    if constexpr (is_number) {
      if (json.is_number_float() && !(std::abs(json.get<double>()) <= largest_number)) {
        return place.reject(json, std::isnan(json.get<double>())
                                      ? "NaN is not a number"
                                      : "exceeds 1e18 in absolute value, which does not occur in files of rocking");
      }
      if (!place.rule.allows(json.get<double>())) return place.reject(json, in_words(place.rule));
    } else if constexpr (std::is_same_v<T, std::string>) {
      const auto& choices = place.rule.choices;
      if (!choices.empty() && std::ranges::find(choices, json.get<std::string>()) == choices.end()) {
        return place.reject(json, in_words(place.rule));
      }
    }
    *static_cast<T*>(value) = json.get<T>();
  }

  void check(const void* value, const ReadingPlace& place) const override {
    const T& held = *static_cast<const T*>(value);
    if constexpr (is_number) {
      const auto number = static_cast<double>(held);
      if (!place.rule.allows(number)) {
        place.problems->push_back({place.pointer, plain(number), in_words(place.rule), ""});
      } else if (!std::isfinite(number)) {
        place.problems->push_back({place.pointer, base::shortest(number), "must be a finite number", ""});
      }
    } else if constexpr (std::is_same_v<T, std::string>) {
      const auto& choices = place.rule.choices;
      if (choices.empty() || std::ranges::find(choices, held) != choices.end()) return;
      place.problems->push_back({place.pointer, held, in_words(place.rule), ""});
    }
  }

  [[nodiscard]] Json schema(const Rule& rule) const override {
    Json schema = {{"type", json_type}};
    Rule stated = rule;
    if (std::is_unsigned_v<T> && is_number && !stated.least && !stated.above) stated.least = 0.0;
    add_rule(stated, schema);
    return schema;
  }

 private:
  static constexpr bool is_number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
  static constexpr const char* kind = std::is_same_v<T, std::string> ? "text"
                                      : std::is_same_v<T, bool>      ? "true or false"
                                      : std::is_same_v<T, double>    ? "a number"
                                      : std::is_unsigned_v<T>        ? "a whole number, not negative"
                                                                     : "a whole number";
  static constexpr const char* json_type = std::is_same_v<T, std::string> ? "string"
                                           : std::is_same_v<T, bool>      ? "boolean"
                                           : std::is_same_v<T, double>    ? "number"
                                                                          : "integer";

  static bool fits(const Json& json) {
    if constexpr (std::is_same_v<T, std::string>) return json.is_string();
    if constexpr (std::is_same_v<T, bool>) return json.is_boolean();
    if constexpr (std::is_same_v<T, double>) return json.is_number();
    if constexpr (is_number && std::is_integral_v<T>) {
      if (json.is_number_unsigned()) return std::in_range<T>(json.get<std::uint64_t>());
      return json.is_number_integer() && std::in_range<T>(json.get<std::int64_t>());
    }
    return false;
  }
};

/// Any JSON value, kept as it is: what is described elsewhere.
class AnyType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override { return *static_cast<const Json*>(value); }
  void read(const Json& json, const ReadingPlace&, void* value) const override { *static_cast<Json*>(value) = json; }
  [[nodiscard]] Json schema(const Rule&) const override { return Json::object(); }
};

}  // namespace

std::string bounds_in_words(const Rule& rule) {
  std::string words;
  const auto add = [&words](std::string_view word, const std::optional<double>& bound) {
    if (bound) words += (words.empty() ? "" : " and ") + std::string(word) + ' ' + plain(*bound);
  };
  add("at least", rule.least);
  add("above", rule.above);
  add("at most", rule.most);
  add("below", rule.below);
  return words;
}

void ReadingPlace::reject(const Json& value, std::string reason, std::string remedy) const {
  problems->push_back({pointer.empty() ? "/" : pointer, brief(value), std::move(reason), std::move(remedy)});
}

void ReadingPlace::reject_changed(const Json& value) const {
  if (!is_fit_checked) return;
  reject(value, "does not fit the rest of the file, which was changed or damaged", "make the file again");
}

ReadingPlace ReadingPlace::at(std::string_view key) const {
  return {.pointer = child_pointer(pointer, key), .rule = rule, .problems = problems, .is_fit_checked = is_fit_checked};
}

ReadingPlace ReadingPlace::at(std::string_view key, const Rule& of_field) const {
  ReadingPlace place = at(key);
  place.rule = of_field;
  return place;
}

Json or_null(Json schema) {
  if (schema.contains("enum") || !schema.contains("type")) {
    return {{"anyOf", Json::array({std::move(schema), {{"type", "null"}}})}};
  }
  if (schema["type"].is_array()) return schema;  // it may be null already
  schema["type"] = Json::array({schema["type"], "null"});
  return schema;
}

void ValueType::check(const void*, const ReadingPlace&) const {}

void ValueType::describe(const std::string&, std::vector<KeyRow>&) const {}

void ValueType::report_missing(const ReadingPlace& place, void*) const {
  place.problems->push_back({place.pointer, "", "is missing", "add \"" + last_key(place.pointer) + "\": " + example()});
}

template <SimpleValue T>
const ValueType& simple_type() {
  return the_only<std::conditional_t<std::is_same_v<T, Json>, AnyType, SimpleType<T>>>();
}

template const ValueType& simple_type<double>();
template const ValueType& simple_type<std::uint64_t>();
template const ValueType& simple_type<std::int64_t>();
template const ValueType& simple_type<int>();
template const ValueType& simple_type<unsigned>();
template const ValueType& simple_type<bool>();
template const ValueType& simple_type<std::string>();
template const ValueType& simple_type<Json>();

}  // namespace rocking
