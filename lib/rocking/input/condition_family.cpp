#include "rocking/input/condition_family.hpp"

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

std::optional<SweptNumber> only_swept_number(const Experiment& experiment) {
  const auto& parameters = experiment.conditions.front().parameters;
  if (parameters.size() != 1) return std::nullopt;
  SweptNumber swept{.pointer = parameters.front().pointer, .values = {}};
  for (const Condition& condition : experiment.conditions) {
    const Json value = Json::parse(condition.parameters.front().value);
    if (!value.is_number()) return std::nullopt;
    swept.values.push_back(value.get<double>());
  }
  return swept;
}

std::function<std::optional<Condition>(double)> condition_family(const Experiment& experiment,
                                                                 const std::string& pointer) {
  Json document = Json::parse(experiment.canonical_text);
  document.erase("sweep");
  return [document, place = Json::json_pointer(pointer)](double value) -> std::optional<Condition> {
    Json one = document;
    one[place] = value;
    try {
      return read_experiment(one.dump()).conditions.front();
    } catch (const base::InputError&) {
      return std::nullopt;  // not an allowed value
    }
  };
}

}  // namespace rocking
