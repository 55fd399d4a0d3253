#include "rocking/scene/check_condition.hpp"

#include <string>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/scene/check_numbers.hpp"
#include "rocking/scene/relations.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;

Problems problems_of(const Condition& condition, SoundGroundMotions& sound) {
  Problems problems;
  check_numbers(condition, sound, problems);
  check_relations(condition, problems);
  return problems;
}

}  // namespace

void check_condition(const Condition& condition) {
  SoundGroundMotions sound;
  Problems problems = problems_of(condition, sound);
  if (!problems.empty()) throw base::InputError(std::move(problems));
}

void check_has_conditions(const Experiment& experiment) {
  if (!experiment.conditions.empty()) return;
  throw base::InputError(
      {.place = "the experiment", .value = "", .reason = "has no conditions", .remedy = "add at least one"});
}

void check_experiment(const Experiment& experiment) {
  check_has_conditions(experiment);
  SoundGroundMotions sound;
  Problems problems;
  for (std::size_t i = 0; i < experiment.conditions.size() && problems.size() < most_problems; ++i) {
    for (base::Problem& problem : problems_of(experiment.conditions[i], sound)) {
      if (experiment.conditions.size() > 1) problem.reason += " (condition " + std::to_string(i) + ')';
      problems.push_back(std::move(problem));
    }
  }
  if (problems.size() > most_problems) problems.resize(most_problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
}

}  // namespace rocking
