#include "rocking/fields/written_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rocking/base/number_text.hpp"
#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

std::string wrong_type(std::string_view wanted, const Json& value) {
  return "must be " + std::string(wanted) + ", not " + std::string(kind_name(value));
}

std::optional<std::int64_t> whole_number(const Json& value) {
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    if (std::in_range<std::int64_t>(number)) return static_cast<std::int64_t>(number);
    return std::nullopt;
  }
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const auto number = value.get<double>();
  constexpr double all_whole = 0x1p53;  // beyond it not every whole number is a double
  if (std::trunc(number) != number || std::abs(number) > all_whole) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

/// `1 to 1000000`
std::string ends_of(const Rule& rule) {
  return std::to_string(static_cast<std::int64_t>(*rule.least)) + " to " +
         std::to_string(static_cast<std::int64_t>(*rule.most));
}

template <class Number>
std::string text_of(Number number) {
  if constexpr (std::is_integral_v<Number>)
    return std::to_string(number);
  else
    return base::shortest(number);
}

}  // namespace

template <class Number>
std::string NumberType<Number>::demand() const {
  if constexpr (std::is_integral_v<Number>) return "must be a whole number from " + ends_of(rule_);
  return std::string(rule_.demand);
}

template <class Number>
Number NumberType<Number>::safe() const {
  return std::is_integral_v<Number> ? static_cast<Number>(*rule_.least) : Number{};
}

template <class Number>
void NumberType<Number>::read(const Json& json, const ReadingPlace& place, void* value) const {
  Number& number = *static_cast<Number*>(value) = safe();
  if constexpr (std::is_integral_v<Number>) {
    const auto found = whole_number(json);
    if (!found || !rule_.allows(static_cast<double>(*found))) return place.reject(json, demand(), rule_.remedy());
    number = static_cast<Number>(*found);
  } else {
    constexpr std::array<std::string_view, 6> no_numbers{"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"};
    if (json.is_string() && std::ranges::find(no_numbers, json.get<std::string>()) != no_numbers.end()) {
      return place.reject(json, "is not a finite number", "give one, as in " + example());
    }
    if (!json.is_number()) {
      return place.reject(json, wrong_type("a number", json),
                          json.is_string() ? "write it without quotes, as in " + example() : rule_.remedy());
    }
    if (!rule_.allows(json.get<double>())) return place.reject(json, demand(), rule_.remedy());
    number = json.get<double>();
  }
}

template <class Number>
void NumberType<Number>::report_missing(const ReadingPlace& place, void* value) const {
  ValueType::report_missing(place, value);
  *static_cast<Number*>(value) = safe();
}

template <class Number>
void NumberType<Number>::check(const void* value, const ReadingPlace& place) const {
  const Number number = *static_cast<const Number*>(value);
  if (rule_.allows(static_cast<double>(number))) return;
  place.problems->push_back({place.pointer, text_of(number), demand(), rule_.remedy()});
}

template <class Number>
Json NumberType<Number>::schema(const Rule&) const {
  return type_of<Number>().schema(rule_);
}

template <class Number>
ValueType::Shown NumberType<Number>::shown(const void* value) const {
  return {.allowed = std::is_integral_v<Number> ? "integer, " + ends_of(rule_) : interval_text(rule_),
          .standard = text_of(*static_cast<const Number*>(value))};
}

template class NumberType<double>;
template class NumberType<int>;
template class NumberType<std::int64_t>;
template class NumberType<std::uint64_t>;

void TextType::read(const Json& json, const ReadingPlace& place, void* value) const {
  if (!json.is_string()) return place.reject(json, wrong_type("text", json), "write it in quotes");
  *static_cast<std::string*>(value) = json.get<std::string>();
}

ValueType::Shown TextType::shown(const void* value) const {
  return {.allowed = "text", .standard = '"' + *static_cast<const std::string*>(value) + '"'};
}

Json NumbersType::json(const void* value) const { return *static_cast<const std::vector<double>*>(value); }

Refusal NumbersType::refusal(const ReadingPlace& place) const {
  const std::string least = std::to_string(length_.least);
  const double first = Json::parse(number_.example()).get<double>();
  Json example = Json::array();
  for (std::size_t i = 0; i < std::max<std::size_t>(length_.least, 2); ++i) {
    example.push_back(first + 0.1 * static_cast<double>(i));
  }
  return {"must be a list of " +
              (length_.least == length_.most ? least : least + " to " + std::to_string(length_.most)) +
              " numbers: " + std::string(place.sentence),
          "give a value such as " + example.dump()};
}

void NumbersType::read(const Json& json, const ReadingPlace& place, void* value) const {
  auto& numbers = *static_cast<std::vector<double>*>(value);
  numbers.clear();
  if (!json.is_array() || json.size() < length_.least || json.size() > length_.most) {
    Refusal why = refusal(place);
    return place.reject(json, std::move(why.reason), std::move(why.remedy));
  }
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::size_t problems_before = place.problems->size();
    double number = 0.0;
    number_.read(json[i], place.at(std::to_string(i)), &number);
    if (place.problems->size() == problems_before) numbers.push_back(number);
  }
}

void NumbersType::report_missing(const ReadingPlace& place, void* value) const {
  static_cast<std::vector<double>*>(value)->clear();
  Refusal why = refusal(place);
  place.problems->push_back({place.pointer, "", std::move(why.reason), std::move(why.remedy)});
}

void NumbersType::check(const void* value, const ReadingPlace& place) const {
  const auto& numbers = *static_cast<const std::vector<double>*>(value);
  if (numbers.size() < length_.least || numbers.size() > length_.most) {
    place.problems->push_back(
        {place.pointer, "", "has " + std::to_string(numbers.size()) + " numbers", "give at least one"});
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) number_.check(&numbers[i], place.at(std::to_string(i)));
}

Json NumbersType::schema(const Rule& rule) const {
  return {{"type", "array"}, {"items", number_.schema(rule)}, {"minItems", length_.least}, {"maxItems", length_.most}};
}

void NameType::read(const Json& json, const ReadingPlace& place, void* value) const {
  const auto name = std::ranges::find_if(names_, [&json](std::string_view each) { return json == each; });
  if (name != names_.end()) return choose(static_cast<std::size_t>(name - names_.begin()), value);
  std::string list;
  for (const std::string_view each : names_) (list += list.empty() ? "\"" : ", \"") += std::string(each) + '"';
  const std::vector<std::string> words(names_.begin(), names_.end());
  const auto nearest = nearest_word(json.is_string() ? json.get<std::string>() : std::string(), words);
  place.reject(json, "must be one of " + list, nearest ? "did you mean \"" + *nearest + "\"?" : "choose one of them");
}

ValueType::Shown NameType::shown(const void* value) const {
  return {.allowed = words_in_code(names_), .standard = '`' + std::string(names_[chosen(value)]) + '`'};
}

std::string NameType::example() const { return quoted_words(names_); }

void OpaqueType::read(const Json& json, const ReadingPlace& place, void*) const {
  if (place.canonical != nullptr) *place.canonical = json;
}

std::string interval_text(const Rule& bounds) {
  return (bounds.least ? '[' + base::shortest(*bounds.least) : '(' + base::shortest(*bounds.above)) + ", " +
         (bounds.most ? base::shortest(*bounds.most) + ']' : base::shortest(*bounds.below) + ')');
}

std::string quoted_words(std::span<const std::string_view> names) {
  std::string words;
  for (const std::string_view name : names) {
    if (!words.empty()) words += name == names.back() ? " or " : ", ";
    words += '"' + std::string(name) + '"';
  }
  return words;
}

std::string words_in_code(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "`" : ", `") + std::string(name) + '`';
  return list;
}

}  // namespace rocking
