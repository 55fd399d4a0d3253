#include "rocking/input/object_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/text/spelling.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_unknown_keys = 10;

std::string wrong_type(std::string_view wanted, const Json& value) {
  return "must be " + std::string(wanted) + ", not " + std::string(kind_name(value));
}

template <class Texts>
std::string listed(const Texts& texts) {
  std::string list;
  for (const auto& text : texts) {
    if (!list.empty()) list += ", ";
    list += '"' + std::string(text) + '"';
  }
  return list;
}

std::string correction(const std::string& written, std::span<const std::string_view> known_keys) {
  std::vector<std::string> known;  // each once: some keys are asked for twice
  for (const std::string_view key : known_keys) {
    if (std::ranges::find(known, key) == known.end()) known.emplace_back(key);
  }
  if (const auto nearest = nearest_word(written, known)) return "did you mean \"" + *nearest + "\"?";
  return known.empty() ? "remove it" : "known keys: " + listed(known);
}

// A whole number, also where it is spelled 2e3 or 500.0.
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

}  // namespace

std::optional<double> checked_number(const Json& value, const std::string& place, const NumberRule& rule,
                                     Problems& problems) {
  if (!value.is_number()) {
    std::string remedy =
        value.is_string() ? "write it without quotes, as in " + std::string(rule.example) : rule.remedy();
    problems.push_back({place, brief(value), wrong_type("a number", value), std::move(remedy)});
    return std::nullopt;
  }
  const auto number = value.get<double>();
  if (!rule.allows(number)) {
    problems.push_back({place, brief(value), std::string(rule.demand), rule.remedy()});
    return std::nullopt;
  }
  return number;
}

ObjectReader::ObjectReader(const Json& source, std::string place, Problems& problems)
    : source_(&source), place_(std::move(place)), problems_(&problems) {
  known_.reserve(32);
  if (source.is_object()) return;
  problems.push_back({place_.empty() ? "the file" : place_, brief(source), wrong_type("an object", source),
                      "write it as { \"key\": value }"});
  source_ = &no_keys();
  problems_ = &ignored_;
}

const Json& ObjectReader::no_keys() {
  static const Json empty = Json::object();
  return empty;
}

bool ObjectReader::has(std::string_view key) { return value(key) != nullptr; }

const Json* ObjectReader::value(std::string_view key) {
  known_.push_back(key);
  const auto found = source_->find(key);
  return found == source_->end() ? nullptr : &*found;
}

bool ObjectReader::is_written(std::string_view key) const {
  return writes_ && (written_.empty() || std::ranges::find(written_, key) != written_.end());
}

void ObjectReader::write(std::string_view key, Json canonical) {
  if (is_written(key)) canonical_[std::string(key)] = std::move(canonical);
}

double ObjectReader::number(std::string_view key, const NumberRule& rule) {
  const Json* found = value(key);
  if (found == nullptr && !rule.standard) report_missing(key, rule.example);
  std::optional<double> read = rule.standard;
  if (found != nullptr) {
    const bool is_sound =
        found->is_number() && rule.allows(found->get<double>());  // mostly, and then without its place
    read = is_sound ? found->get<double>() : checked_number(*found, place_of(key), rule, *problems_);
  }
  if (read) write(key, *read);
  return read.value_or(0.0);
}

std::int64_t ObjectReader::integer(std::string_view key, const IntegerRule& rule) {
  const Json* found = value(key);
  if (found == nullptr && !rule.standard) report_missing(key, std::to_string(rule.example));
  std::optional<std::int64_t> read = rule.standard;
  if (found != nullptr) {
    read = whole_number(*found);
    if (!read || !rule.allows(*read)) {
      reject(key, rule.demand(), rule.remedy());
      read.reset();
    }
  }
  if (read) write(key, *read);
  return read.value_or(rule.low);
}

std::string ObjectReader::text(std::string_view key, std::string_view standard) {
  const Json* found = value(key);
  std::string read(standard);
  if (found != nullptr && !found->is_string()) {
    reject(key, wrong_type("text", *found), "write it in quotes");
  } else if (found != nullptr) {
    read = found->get<std::string>();
  }
  write(key, read);
  return read;
}

std::size_t ObjectReader::choice(std::string_view key, std::span<const std::string_view> names, std::size_t standard) {
  const Json* found = value(key);
  std::size_t chosen = standard;
  if (found != nullptr) {
    const auto name = std::find_if(names.begin(), names.end(), [found](std::string_view n) { return *found == n; });
    if (name == names.end()) {
      const std::vector<std::string> words(names.begin(), names.end());
      const std::string written = found->is_string() ? found->get<std::string>() : std::string();
      const auto nearest = nearest_word(written, words);
      reject(key, "must be one of " + listed(names),
             nearest ? "did you mean \"" + *nearest + "\"?" : "choose one of them");
    } else {
      chosen = static_cast<std::size_t>(name - names.begin());
    }
  }
  write(key, names[chosen]);
  return chosen;
}

void ObjectReader::reject(std::string_view key, std::string reason, std::string remedy) {
  const Json* found = value(key);
  problems_->push_back({place_of(key), found == nullptr ? "" : brief(*found), std::move(reason), std::move(remedy)});
}

void ObjectReader::reject(std::string reason, std::string remedy) {
  problems_->push_back({place_, source_ == &no_keys() ? "" : brief(*source_), std::move(reason), std::move(remedy)});
}

void ObjectReader::report_missing(std::string_view key, std::string_view example) {
  problems_->push_back({place_of(key), "", "is missing", "add \"" + std::string(key) + "\": " + std::string(example)});
}

Json ObjectReader::finish() {
  std::size_t unknown = 0;
  for (const auto& [key, found] : source_->items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    if (++unknown > most_unknown_keys) continue;
    problems_->push_back({place_of(key), brief(found), "is not a key of this format", correction(key, known_)});
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
