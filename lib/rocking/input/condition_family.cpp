#include "rocking/input/condition_family.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/fields/field_checker.hpp"
#include "rocking/fields/field_reader.hpp"
#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

void put_value(Json& document, const Parameter& parameter, const std::string& place) {
  try {
    document[Json::json_pointer(parameter.pointer)] = json_of(parameter.value);
  } catch (const Json::exception&) {
    throw base::InputError({.place = child_pointer(place, parameter.pointer),
                            .value = json_text_of(parameter.value),
                            .reason = "is at no place of the experiment",
                            .remedy = ""});
  }
}

Json document_without_sweep(const Experiment& experiment) {
  Json document = Json::parse(experiment.canonical_text);
  document.erase("sweep");
  document.erase("unknown");
  return document;
}

/// Sets a number among the values of a condition in C++.
class FieldSetter final : public FieldChecker {
 public:
  /// `document`: has the numbers of all places that are set.
  FieldSetter(const Json& document, const Parameter& number, Problems& problems)
      : FieldChecker("", problems), document_(&document), number_(&number) {}

  [[nodiscard]] bool is_set() const { return is_set_; }

  void field(const Key& key, const ValueType& type, void* value, Absent) override {
    const std::string place = place_ + std::string(key.name);
    if (!is_within(number_->pointer, place)) return;
    const Json& whole = document_->at(Json::json_pointer(place));  // of a number in a law, the law
    type.read(whole, {.pointer = place, .problems = problems_}, value);
    is_set_ = true;
  }
  bool one_of(std::span<const Alternative> keys, std::size_t& chosen, void* value, Absent absent) override {
    FieldChecker::one_of(keys, chosen, value, absent);
    return true;
  }
  bool stands(std::string_view key, bool is_given) override {
    return is_given || is_within(number_->pointer, place_ + std::string(key));
  }

 private:
  const Json* document_;
  const Parameter* number_;
  bool is_set_ = false;
};

std::optional<Condition> where_allowed(const ConditionMaker& family, const std::vector<Parameter>& values) {
  try {
    return family(values);
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

ConditionMaker::ConditionMaker(const Experiment& experiment, Surroundings surroundings)
    : document_(document_without_sweep(experiment)), surroundings_(std::move(surroundings)) {
  const Json fluctuation = document_.value("fluctuation", Json::object());
  const bool is_relative = std::any_of(fluctuation.begin(), fluctuation.end(),
                                       [](const Json& scatter) { return scatter.contains("relative_sigma"); });
  const bool states_horizon = number("/horizon/transient_periods") && number("/horizon/sampled_periods");
  if (is_relative || !states_horizon || document_["excitation"]["kind"] == Recorded::name) return;
  try {
    read_once_ = read({});
  } catch (const base::InputError&) {  // beside the sweep its values are not allowed
  }
}

Condition ConditionMaker::operator()(const std::vector<Parameter>& values) const {
  auto found = set(values);
  return found ? *std::move(found) : read(values);  // which tells what is wrong
}

Condition ConditionMaker::read(const std::vector<Parameter>& values) const {
  Json one = document_;
  for (const Parameter& value : values) one[Json::json_pointer(value.pointer)] = json_of(value.value);
  Condition condition = experiment_in(one.dump(), {}, surroundings_).conditions.front();
  condition.parameters = values;
  return condition;
}

std::optional<Condition> ConditionMaker::set(const std::vector<Parameter>& values) const {
  if (!read_once_) return std::nullopt;
  UnsweptExperiment question{.title = {}, .seed = 0, .condition = *read_once_};
  FiledRecords no_records(nullptr);
  Problems problems;
  Json document = document_;
  for (const Parameter& value : values) {
    if (!number_in(value.value) || !number(value.pointer)) return std::nullopt;
    document[Json::json_pointer(value.pointer)] = json_of(value.value);
  }
  for (const Parameter& value : values) {
    FieldSetter setter(document, value, problems);
    keys_of(setter, question, no_records);
    if (!setter.is_set()) return std::nullopt;
  }
  if (problems.empty()) check_relations(question.condition, problems);
  if (!problems.empty()) return std::nullopt;
  question.condition.parameters = values;
  return std::move(question.condition);
}

std::optional<double> ConditionMaker::number(const std::string& pointer) const {
  if (!pointer.starts_with('/') || pointer.find('~') != std::string::npos) return std::nullopt;
  const Json::json_pointer place(pointer);
  if (!document_.contains(place) || !document_.at(place).is_number()) return std::nullopt;
  return document_.at(place).get<double>();
}

std::optional<SweptNumber> only_swept_number(const Experiment& experiment) {
  const auto& parameters = experiment.conditions.front().parameters;
  if (parameters.size() != 1) return std::nullopt;
  SweptNumber swept{.pointer = parameters.front().pointer, .values = {}};
  for (const Condition& condition : experiment.conditions) {
    const std::optional<double> value = number_in(condition.parameters.front().value);
    if (!value) return std::nullopt;
    swept.values.push_back(*value);
  }
  return swept;
}

std::function<std::optional<Condition>(double)> condition_family(const Experiment& experiment,
                                                                 const std::string& pointer) {
  return [family = ConditionMaker(experiment), pointer](double value) {
    return where_allowed(family, {{pointer, value}});
  };
}

ConditionReader::ConditionReader(const Json& experiment) : document_(without_suite(experiment)) {
  if (document_.is_null()) return;
  document_.erase("sweep");
  if (!suite_axis(experiment)) return;
  for (const Json& record : experiment["excitation"]["suite"]) records_[name_of_record(record)] = record;
}

Condition ConditionReader::read(std::vector<Parameter> parameters, const std::string& place) {
  UnsweptExperiment question;
  if (!document_.is_null()) {
    std::uint64_t stream = 0;
    for (const Parameter& parameter : parameters) {
      const auto* name = std::get_if<std::string>(&parameter.value);
      const auto record = name != nullptr ? records_.find(*name) : records_.end();
      if (parameter.pointer == suite_place && record != records_.end()) {
        put_record(document_, record->second);
        stream = stream_of(record->second);
      } else {
        put_value(document_, parameter, place);
      }
    }
    Problems problems;
    static const std::array<std::string, 1> canonical{"format"};  // no more of the canonical text is needed
    question = read_question(document_, nullptr, problems, canonical).question;
    for (base::Problem& problem : problems) problem.place = place + ": " + problem.place;
    if (!problems.empty()) throw base::InputError(std::move(problems));
    question.condition.record_stream = stream;
  }
  question.condition.parameters = std::move(parameters);
  return std::move(question.condition);
}

}  // namespace rocking
