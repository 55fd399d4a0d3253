#include "rocking/input/reading_keys.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// `"a", "b" or "c"`.
std::string in_words(std::span<const std::string_view> names) {
  std::string words;
  for (const std::string_view name : names) {
    if (!words.empty()) words += name == names.back() ? " or " : ", ";
    words += '"' + std::string(name) + '"';
  }
  return words;
}

std::optional<std::uint64_t> seed_in(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_string()) return std::nullopt;
  return seed_from_text(value.get_ref<const std::string&>());
}

/// Whether the sweep changes what stands at `place`, or something within it.
bool is_swept(const Json* sweep, std::string_view place) {
  if (sweep == nullptr || !sweep->is_array()) return false;
  return std::ranges::any_of(*sweep, [place](const Json& axis) {
    if (!axis.is_object() || !axis.contains("parameter") || !axis["parameter"].is_string()) return false;
    const auto& pointer = axis["parameter"].get_ref<const std::string&>();
    return is_within(pointer, place) || is_within(place, pointer);
  });
}

std::string list_demand(const ListLength& length) {
  const std::string least = std::to_string(length.least);
  return "must be a list of " + (length.least == length.most ? least : least + " to " + std::to_string(length.most)) +
         " numbers";
}

std::string list_example(const ListLength& length, const NumberRule& rule) {
  const double first = Json::parse(rule.example).get<double>();
  Json list = Json::array();
  for (std::size_t i = 0; i < std::max<std::size_t>(length.least, 2); ++i) {
    list.push_back(first + 0.1 * static_cast<double>(i));
  }
  return list.dump();
}

/// Reports that there is none of the keys.
void report_none_of(ObjectReader& in, std::span<const UnitKey> units) {
  std::string remedy = "add ";
  for (const UnitKey& unit : units) {
    if (&unit != units.data()) remedy += ", or ";
    remedy += '"' + std::string(unit.key.name) + "\": " + std::string(unit.rule.example);
  }
  in.reject(units.front().key.name, "is missing", remedy);
}

}  // namespace

void ReadingKeys::text(const Key& key, std::string& value) { value = in_.text(key.name, value); }

void ReadingKeys::number(const Key& key, double& value, const NumberRule& rule, Absent absent) {
  if (!in_.has(key.name) && absent == Absent::omitted) return;
  value = in_.number(key.name, absent == Absent::error ? rule : rule.with_default(value));
}

void ReadingKeys::whole_number(const Key& key, std::int64_t& value, const IntegerRule& rule, Absent absent) {
  if (!in_.has(key.name) && absent == Absent::omitted) return;
  value = in_.integer(key.name, absent == Absent::error ? rule : rule.with_default(value));
}

void ReadingKeys::numbers(const Key& key, std::vector<double>& values, const ListLength& length, const NumberRule& rule,
                          Absent) {
  values.clear();
  const Json* found = in_.value(key.name);
  if (found == nullptr || !found->is_array() || found->size() < length.least || found->size() > length.most) {
    return in_.reject(key.name, list_demand(length) + ": " + std::string(key.sentence),
                      "give a value such as " + list_example(length, rule));
  }
  for (std::size_t i = 0; i < found->size(); ++i) {
    const std::string place = child_pointer(in_.place_of(key.name), std::to_string(i));
    if (const auto number = checked_number((*found)[i], place, rule, in_.problems())) values.push_back(*number);
  }
  in_.write(key.name, values);
}

/// The law in the object that stands at the key.
void ReadingKeys::law(const Key& key, Quantity& value, const NumberRule& rule) {
  in_.object(key.name, [&](ObjectReader& object) {
    std::vector<std::size_t> given;
    for (std::size_t i = 0; i < law_names.size(); ++i) {
      if (object.has(law_names[i])) given.push_back(i);
    }
    if (given.size() != 1) {
      return in_.reject(key.name, given.empty() ? "has no distribution" : "cannot have two distributions",
                        "give {\"uniform\": [a, b]}, {\"normal\": {\"mean\": m, \"sigma\": s}}, or another law: " +
                            in_words(law_names));
    }
    const std::size_t problems_before = problem_count();
    value = law_at(given.front());
    ReadingKeys keys(object, context_);
    keys_of_law(keys, value, rule);
    if (problem_count() == problems_before) {
      if (auto refusal = refusal_of_law(value)) keys.reject(law_names[given.front()], *std::move(refusal));
    }
    if (problem_count() != problems_before) value = 0.0;  // its numbers are no law
  });
}

void ReadingKeys::quantity(const Key& key, Quantity& value, const NumberRule& rule, Absent absent) {
  const Json* found = in_.value(key.name);
  if (found != nullptr && found->is_object()) return law(key, value, rule);
  value = in_.number(key.name, absent == Absent::error ? rule : rule.with_default(mean_of(value)));
}

void ReadingKeys::word(const Key& key, std::size_t& chosen, std::span<const std::string_view> names, Absent absent) {
  const Json* found = in_.value(key.name);
  if (found == nullptr) {
    if (absent == Absent::error) {
      in_.reject(key.name, "is missing", "add \"" + std::string(key.name) + "\": " + in_words(names));
    }
    if (absent != Absent::standard) return;
  }
  chosen = in_.choice(key.name, names, chosen);
}

void ReadingKeys::words(const Key& key, std::vector<std::size_t>& chosen, std::span<const std::string_view> names) {
  chosen.clear();
  const Json* found = in_.value(key.name);
  const auto place = [names](const Json& word) { return std::ranges::find(names, word); };
  const auto is_known = [&](const Json& word) { return place(word) != names.end(); };
  if (found == nullptr || !found->is_array() || found->empty() || !std::ranges::all_of(*found, is_known)) {
    return in_.reject(key.name, "must be a list of " + in_words(names),
                      "give \"" + std::string(key.name) + "\": [\"" + std::string(names[0]) + "\", \"" +
                          std::string(names[1]) + "\"]");
  }
  for (const Json& word : *found) chosen.push_back(static_cast<std::size_t>(place(word) - names.begin()));
  in_.write(key.name, *found);
}

void ReadingKeys::forms(const Key& key, Formed& value, std::span<const Form> forms, std::string_view remedy,
                        Absent absent) {
  const Json* found = in_.value(key.name);
  if (found == nullptr && absent == Absent::omitted) return;
  const auto is_word = [](const Form& form) { return form.rule == nullptr; };
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (!is_word(forms[i]) || (found == nullptr ? i != value.form : *found != forms[i].name)) continue;
    in_.write(key.name, forms[i].name);
    value.form = i;
    return;
  }
  value.form = 0;
  if (found != nullptr && found->is_string() && std::ranges::any_of(forms, is_word)) {
    value.value = 0.0;
    return in_.reject(key.name, std::string(forms.front().rule->demand), std::string(remedy));
  }
  const auto of_object =
      std::ranges::find_if(forms, [](const Form& form) { return form.rule != nullptr && !form.name.empty(); });
  if (found == nullptr || !found->is_object() || has_law(*found) || of_object == forms.end()) {
    return quantity(key, value.value, *forms.front().rule, absent);
  }
  value.form = static_cast<std::size_t>(of_object - forms.begin());
  object(key, absent, [&](Keys& keys) {
    const Key inner{of_object->name, ""};
    if (of_object->may_be_drawn) return keys.quantity(inner, value.value, *of_object->rule, Absent::error);
    double number = 0.0;
    keys.number(inner, number, *of_object->rule, Absent::error);
    value.value = number;
  });
}

void ReadingKeys::mode(const Key& key, std::optional<section::ResponseMode>& value) {
  const Json* found = in_.value(key.name);
  if (found == nullptr) return;
  const auto mode = found->is_string() ? section::response_mode_named(found->get<std::string>()) : std::nullopt;
  const bool exists =
      mode && (mode->kind != section::ResponseKind::periodic || (mode->rocks >= 0 && mode->periods > 0));
  if (!exists) {
    return in_.reject(key.name, "is not the name of a response mode",
                      "give \"overturned\", \"rest\", \"chaotic\", \"unresolved\", or (m,n) such as \"(1,3)\"");
  }
  in_.write(key.name, to_string(*mode));
  value = mode;
}

void ReadingKeys::seed(const Key& key, std::uint64_t& value) {
  if (const Json* found = in_.value(key.name)) {
    const auto read = seed_in(*found);
    if (!read) {
      in_.reject(key.name, "must be a whole number of at most 64 bits", "give a value such as \"0x2012\" or 8210");
    }
    value = read.value_or(0);
  }
  in_.write(key.name, seed_text(value));
}

void ReadingKeys::sweep(const Key& key) {
  if (const Json* found = in_.value(key.name)) in_.write(key.name, *found);
}

void ReadingKeys::unknowns(const Key& key) {
  if (const Json* found = in_.value(key.name)) in_.write(key.name, *found);
}

void ReadingKeys::scatter(std::initializer_list<Scatter> of) {
  const bool is_relative = in_.has("relative_sigma");
  if (is_relative && in_.has("sigma")) return in_.reject("relative_sigma", "excludes \"sigma\"", "keep one of them");
  const double given = in_.number(is_relative ? "relative_sigma" : "sigma", rules::sigma);
  for (const Scatter& each : of) {
    const double sigma = is_relative ? given * std::abs(each.mean()) : given;
    if (rules::sigma.allows(sigma)) {
      *each.sigma = sigma;
    } else {
      in_.reject("relative_sigma", "makes a standard deviation above 1e6", "give a smaller fraction of the mean");
    }
  }
}

bool ReadingKeys::one_of(std::span<const UnitKey> units, QuantityInUnit& value, Absent absent) {
  const std::size_t problems_before = problem_count();
  std::optional<std::size_t> given;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::string_view key = units[i].key.name;
    if (!in_.has(key)) continue;
    if (given) {
      in_.reject(key, "excludes \"" + std::string(units[*given].key.name) + '"', "keep one of them");
    } else {
      given = i;
    }
  }
  if (!given && absent == Absent::error) {
    report_none_of(in_, units);
    return false;
  }
  const UnitKey& unit = units[given.value_or(0)];
  Quantity read = value.value;
  quantity(unit.key, read, unit.rule, absent);
  if (problem_count() != problems_before) return false;
  value = {given.value_or(0), std::move(read)};
  return true;
}

void ReadingKeys::record_format(const Key& key, std::optional<RecordFormat>& value) {
  const Json* found = in_.value(key.name);
  if (found == nullptr || *found == record_format_choices.back()) return;  // the canonical text does not state `auto`
  const std::size_t chosen = in_.choice(key.name, record_format_choices, automatic_record_format);
  if (chosen != automatic_record_format) value = static_cast<RecordFormat>(chosen);
}

void ReadingKeys::file(const Key& file, const Key& digest, std::string& name) {
  name = read_named_file(in_, file.name, digest.name, context_.files);
}

bool ReadingKeys::suite(const Key& key) {
  if (!in_.has(key.name)) return true;
  refuse_suite_here(in_, key.name);
  in_.ignore_others();
  return false;
}

void ReadingKeys::ground_motion(const GroundMotionReading& how, const std::optional<Strength>& strength,
                                Recorded& recorded) {
  if (how.format == RecordFormat::columns && !how.unit && !in_.has("units")) {
    return in_.reject("units", "is missing; \"format\": \"columns\" does not state the unit of the accelerations",
                      "add \"units\": \"m/s2\"; known: " + record_units_in_words());
  }
  if (how.name.empty() || context_.files == nullptr) return;
  auto motion = context_.files->motion(how, in_.problems());
  if (!motion) return;
  if (strength) {
    recorded.scale = scale_for(in_, *strength, *context_.files, motion, how.gravity);
    recorded.measure_periods = strength->periods;
  }
  recorded.ground_motion = std::move(motion);
}

void ReadingKeys::object(const Key& key, Absent, const Part& part) {
  in_.object(key.name, [this, &part](ObjectReader& inner) {
    ReadingKeys keys(inner, context_);
    part(keys);
  });
}

void ReadingKeys::number_or_object(const Key& key, bool, const Part& number, const Part& with_more) {
  const Json* found = in_.value(key.name);
  if (found == nullptr || !found->is_object()) return number(*this);
  object(key, Absent::standard, with_more);
}

void ReadingKeys::kinds(const Key& key, std::span<const std::string_view> names, std::size_t kind,
                        const std::function<void(Keys&, std::size_t)>& part) {
  const std::size_t problems_before = problem_count();
  const std::size_t chosen = in_.choice(key.name, names, kind);
  if (problem_count() != problems_before) return in_.ignore_others();
  part(*this, chosen);
}

Absent ReadingKeys::follows_from(std::span<const std::string_view> places) const {
  const bool swept = std::ranges::any_of(places, [this](auto place) { return is_swept(context_.sweep, place); });
  return swept ? Absent::omitted : Absent::standard;
}

void ReadingKeys::reject(std::string_view key, Refusal refusal) {
  if (key.empty()) return in_.reject(std::move(refusal.reason), std::move(refusal.remedy));
  in_.reject(key, std::move(refusal.reason), std::move(refusal.remedy));
}

void ReadingKeys::exclude(std::string_view key, std::string_view other, Refusal refusal) {
  if (in_.has(other)) reject(key, std::move(refusal));
}

void ReadingKeys::refuse(std::string_view key, std::string_view reason, std::string_view remedy) {
  if (in_.has(key)) in_.reject(key, std::string(reason), std::string(remedy));
}

}  // namespace rocking
