#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/studies/threshold/bands.hpp"
#include "rocking/studies/threshold/study.hpp"

namespace rocking {
namespace {

/// Most motions of a scan, over all combinations.
constexpr std::uint64_t most_motions = 10'000'000;

/// The motions of one combination of the other swept values.
struct ThresholdCase {
  std::vector<Parameter> parameters;
  std::shared_ptr<const ConditionMaker> maker;
  std::vector<Parameter> set = {};  ///< what of the parameters the maker sets: all but the record of a suite

  [[nodiscard]] Condition at(const std::string& pointer, double value) const {
    std::vector<Parameter> values = set;
    values.push_back({pointer, value});
    return (*maker)(values);
  }
};

/// The maker of conditions under one record of a suite.
std::shared_ptr<const ConditionMaker> maker_under(const SweptValue& record, const Json& canonical,
                                                  const Surroundings& surroundings) {
  Json one = without_suite(canonical);
  const Json& records = canonical.at("excitation").at("suite");
  for (const Json& each : records) {
    if (swept_value(name_of_record(each)) == record) put_record(one, each);
  }
  Experiment experiment;
  experiment.canonical_text = one.dump();
  return std::make_shared<ConditionMaker>(experiment, surroundings);
}

std::vector<ThresholdCase> cases_of(const Experiment& experiment, const ThresholdQuestion& question) {
  const Surroundings surroundings = seen_from(question.folder);
  const Json canonical = Json::parse(experiment.canonical_text);
  const bool has_suite = suite_axis(canonical).has_value();
  const auto common = std::make_shared<const ConditionMaker>(experiment, surroundings);
  std::vector<ThresholdCase> cases;
  for (const Condition& condition : experiment.conditions) {
    ThresholdCase next{.parameters = condition.parameters, .maker = common};
    std::erase_if(next.parameters, [&](const Parameter& each) { return each.pointer == question.of; });
    if (std::ranges::find(cases, next.parameters, &ThresholdCase::parameters) != cases.end()) continue;
    for (const Parameter& each : next.parameters) {
      if (has_suite && each.pointer == suite_place) {
        next.maker = maker_under(each.value, canonical, surroundings);
      } else {
        next.set.push_back(each);
      }
    }
    cases.push_back(std::move(next));
  }
  return cases;
}

/// The values that the sweep gives the number; empty if it is not swept.
std::vector<double> swept_values(const Experiment& experiment, const std::string& pointer) {
  std::vector<double> values;
  for (const Condition& condition : experiment.conditions) {
    for (const Parameter& each : condition.parameters) {
      if (each.pointer == pointer) values.push_back(number_in(each.value).value());
    }
  }
  return values;
}

void check_place(const Experiment& experiment, const std::string& pointer) {
  if (experiment.canonical_text.empty()) {
    refuse("of", pointer, "is a place in a text, and this experiment was made in C++ without one");
  }
  const Json canonical = Json::parse(experiment.canonical_text);
  Problems problems;
  const Json asked_for{{"parameter", pointer}};
  FieldReader in(asked_for, "", problems);
  static_cast<void>(read_swept_place(in, canonical));
  for (base::Problem& problem : problems) problem.place = "of";
  if (!problems.empty()) throw base::InputError(std::move(problems));
  if (canonical.at(Json::json_pointer(pointer)).is_number()) return;
  refuse("of", pointer, "is " + brief(canonical.at(Json::json_pointer(pointer))) + " in this experiment, not a number");
}

/// The question with its range, steps and accuracy.
ThresholdQuestion completed(const Experiment& experiment, ThresholdQuestion question) {
  const std::vector<double> values = swept_values(experiment, question.of);
  if (values.empty() && !(question.from && question.to)) {
    refuse(question.from ? "to" : "from", "",
           "is missing: the experiment does not sweep " + question.of + ", whose range must be given by both ends");
  }
  if (!question.from) question.from = std::ranges::min(values);
  if (!question.to) question.to = std::ranges::max(values);
  if (!(*question.from < *question.to)) {
    refuse("from", base::shortest(*question.from),
           "must be less than the other end of the range, " + base::shortest(*question.to));
  }
  if (!question.steps) question.steps = question.probability ? 20 : 200;
  if (!question.accuracy) question.accuracy = question.probability ? 0.02 : 1e-9;
  return question;
}

/// Throws where a number is drawn and no probability is given, or the other way round.
void check_randomness(const Condition& condition, const ThresholdQuestion& question) {
  const auto place = place_of_randomness(condition.scene);
  if (place && !question.probability) {
    throw base::InputError({std::string(*place), "", "is random, so that the event has a probability at each value",
                            "give the probability that is sought, such as `--probability 0.5`, or a number here"});
  }
  if (!place && question.probability) {
    refuse("probability", base::shortest(*question.probability),
           "is asked for, and nothing in this experiment is random: every realisation is the same");
  }
}

/// Looks at both ends of the range, and at one value within.
BalanceAngles checked_cases(const std::vector<ThresholdCase>& cases, const ThresholdQuestion& question) {
  std::optional<BalanceAngles> balance;
  for (const ThresholdCase& one : cases) {
    for (const double value : {*question.from, scanned_values(question)[1], *question.to}) {
      const Condition condition = one.at(question.of, value);
      check_randomness(condition, question);
      check_friction(question.event, condition);
      static_cast<void>(in_units_of_balance(question.event, {condition}));
      balance = joined(balance, balance_of(condition.scene));
    }
  }
  return balance.value();
}

/// The checked question, its cases, and where their blocks are in balance.
std::tuple<ThresholdQuestion, std::vector<ThresholdCase>, BalanceAngles> checked(
    const Experiment& experiment, const ThresholdQuestion& asked_question) {
  check_has_conditions(experiment);
  check_fields(asked_question);
  check_place(experiment, asked_question.of);
  const ThresholdQuestion question = completed(experiment, asked_question);
  std::vector<ThresholdCase> cases = cases_of(experiment, question);
  if (cases.size() * *question.steps > most_motions) {
    refuse("steps", std::to_string(*question.steps),
           "makes more than " + std::to_string(most_motions) + " motions for " + std::to_string(cases.size()) +
               " combinations of the other values; give fewer");
  }
  const BalanceAngles balance = checked_cases(cases, question);
  return {question, std::move(cases), balance};
}

bool happens(const RealisationResult& result, const ResponseEvent& asked_event, const Condition& condition) {
  const ResponseEvent event = in_units_of_balance(asked_event, {condition});
  return result.termination == dynamics::Termination::overturned || event.is_exceeded(result.peaks);
}

ThresholdPoint point_of(const Condition& condition, const ResponseEvent& event, double value, base::StopRequest stop) {
  using dynamics::EventKind;
  const RealisationResult result = realise_unchecked(condition, 0, 0, stop);
  const auto count = [&events = result.operations.events](EventKind kind) {
    return events[static_cast<std::size_t>(kind)];
  };
  const bool has_happened = happens(result, event, condition);
  return {.value = value,
          .happens = has_happened,
          .impacts = count(EventKind::impact_stick) + count(EventKind::impact_slip),
          .termination = result.termination,
          .counts = {.successes = has_happened ? 1U : 0U, .trials = 1}};
}

}  // namespace

void check_question(const Experiment& experiment, const ThresholdQuestion& question) {
  static_cast<void>(checked(experiment, question));
}

ThresholdStudy thresholds(const Experiment& experiment, const ThresholdQuestion& question, const Execution& execution) {
  const auto [whole, cases, balance] = checked(experiment, question);
  const OptionsOfExecution asked_for(execution);
  const PointAt point_at = [&cases = cases, &whole = whole, &asked_for](std::size_t place, double value) {
    return point_of(cases[place].at(whole.of, value), whole.event, value, asked_for.stop());
  };
  const TrialsAt trials_at = [&, &cases = cases, &whole = whole](std::size_t place, double value) -> Trials {
    return [&, condition = cases[place].at(whole.of, value)](std::uint64_t realisation) {
      const RealisationResult result = realise_unchecked(condition, experiment.seed, realisation, asked_for.stop());
      return happens(result, whole.event, condition);
    };
  };
  std::vector<ThresholdBands> found = whole.probability
                                          ? bands_by_probability(cases.size(), whole, trials_at, asked_for.options())
                                          : bands_of(cases.size(), whole, point_at, asked_for.options());
  ThresholdStudy study{.question = whole, .conditions = {}, .balance = balance};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    study.conditions.push_back({cases[i].parameters, std::move(found[i])});
  }
  return study;
}

}  // namespace rocking
