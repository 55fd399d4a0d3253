#include "rocking/input/condition_family.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// The experiment at the document; absent where a value of it is not allowed.
std::optional<Condition> condition_of(const Json& document) {
  try {
    return experiment_in(document.dump()).conditions.front();
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

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

}  // namespace

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
  return [document = document_without_sweep(experiment),
          place = Json::json_pointer(pointer)](double value) -> std::optional<Condition> {
    Json one = document;
    one[place] = value;
    return condition_of(one);
  };
}

SecondParameter second_parameter(const Experiment& experiment, const std::vector<std::string>& pointers) {
  const Json document = document_without_sweep(experiment);
  const auto refuse = [](const std::string& pointer, const std::string& reason, const std::string& remedy) {
    throw base::InputError(
        base::Problem{.place = "--second-parameter", .value = pointer, .reason = reason, .remedy = remedy});
  };
  SecondParameter second{.pointers = pointers, .value = 0.0};
  for (const std::string& pointer : pointers) {
    const bool is_pointer = pointer.starts_with('/') && pointer.find('~') == std::string::npos;
    const bool is_there = is_pointer && document.contains(Json::json_pointer(pointer));
    if (!is_there || !document[Json::json_pointer(pointer)].is_number()) {
      refuse(pointer, "is no number of the experiment", "give a JSON pointer such as /excitation/frequency_ratio");
    }
    const auto& swept = experiment.conditions.front().parameters;
    if (!swept.empty() && swept.front().pointer == pointer) refuse(pointer, "is swept", "give another number");
  }
  second.value = document[Json::json_pointer(pointers.front())].get<double>();
  if (pointers.size() > 1 && second.value == 0.0) {
    refuse(pointers.front(), "is 0, and the others cannot keep their ratio to it", "give another one first");
  }
  return second;
}

std::function<std::optional<Condition>(double, double)> condition_plane(const Experiment& experiment,
                                                                        const std::string& pointer,
                                                                        const SecondParameter& second) {
  return [document = document_without_sweep(experiment), place = Json::json_pointer(pointer), second](
             double at_first, double at_second) -> std::optional<Condition> {
    Json one = document;
    one[place] = at_first;
    for (const std::string& text : second.pointers) {
      Json& number = one[Json::json_pointer(text)];
      // The first one is set exactly.
      number = &text == &second.pointers.front() ? at_second : number.get<double>() * (at_second / second.value);
    }
    return condition_of(one);
  };
}

std::function<Condition(const std::vector<Parameter>&)> condition_maker(const Experiment& experiment,
                                                                        const Surroundings& surroundings) {
  return [document = document_without_sweep(experiment), surroundings](const std::vector<Parameter>& values) {
    Json one = document;
    for (const Parameter& value : values) one[Json::json_pointer(value.pointer)] = json_of(value.value);
    Condition condition = experiment_in(one.dump(), {}, surroundings).conditions.front();
    condition.parameters = values;
    return condition;
  };
}

ConditionReader::ConditionReader(const Json& experiment) : document_(without_suite(experiment)) {
  if (document_.is_null()) return;
  document_.erase("sweep");
  if (!suite_axis(experiment)) return;
  for (const Json& record : experiment["excitation"]["suite"]) records_[record.at("file")] = record;
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
