#include "rocking/scene/check_condition.hpp"

#include <string>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/ground_motion_reading.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;

Problems problems_of(const Condition& condition, SoundGroundMotions& sound) {
  Problems problems;
  check_numbers(condition, sound, problems);
  check_relations(condition, problems);
  return problems;
}

class CheckingKeys final : public Keys {
 public:
  CheckingKeys(double gravity, SoundGroundMotions& sound, Problems& problems)
      : gravity_(gravity), sound_(&sound), problems_(&problems) {}

  void text(const Key&, std::string&) override {}
  void word(const Key&, std::size_t&, std::span<const std::string_view>, Absent) override {}
  void words(const Key&, std::vector<std::size_t>&, std::span<const std::string_view>) override {}
  void mode(const Key&, std::optional<section::ResponseMode>&) override {}
  void seed(const Key&, std::uint64_t&) override {}
  void sweep(const Key&) override {}
  void unknowns(const Key&) override {}
  void record_format(const Key&, std::optional<RecordFormat>&) override {}
  void file(const Key&, const Key&, std::string&) override {}
  bool suite(const Key&) override { return true; }
  bool stands(std::string_view, bool is_given) override { return is_given; }

  void number(const Key& key, double& value, const NumberRule& rule, Absent) override { check(key.name, value, rule); }

  void whole_number(const Key& key, std::int64_t& value, const IntegerRule& rule, Absent) override {
    if (!rule.allows(value)) report(key.name, std::to_string(value), {rule.demand(), rule.remedy()});
  }

  void quantity(const Key& key, Quantity& quantity, const NumberRule& rule, Absent) override {
    if (const auto* number = std::get_if<double>(&quantity)) return check(key.name, *number, rule);
    const std::size_t problems_before = problems_->size();
    object(key, Absent::error, [&](Keys& keys) { keys_of_law(keys, quantity, rule); });
    if (problems_->size() != problems_before) return;
    if (auto refusal = refusal_of_law(quantity)) {
      report(std::string(key.name) + '/' + std::string(law_names[quantity.index() - 1]), "", *std::move(refusal));
    }
  }

  void numbers(const Key& key, std::vector<double>& values, const ListLength& length, const NumberRule& rule,
               Absent) override {
    if (values.size() < length.least || values.size() > length.most) {
      report(key.name, "", {"has " + std::to_string(values.size()) + " numbers", "give at least one"});
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      check(std::string(key.name) + '/' + std::to_string(i), values[i], rule);
    }
  }

  void forms(const Key& key, Formed& value, std::span<const Form> forms, std::string_view, Absent absent) override {
    const Form& form = forms[value.form];
    if (form.rule == nullptr) return;
    if (form.name.empty()) return quantity(key, value.value, *form.rule, absent);
    object(key, absent, [&](Keys& keys) { keys.quantity({form.name, ""}, value.value, *form.rule, Absent::error); });
  }

  void scatter(std::initializer_list<Scatter> of) override {
    for (const Scatter& each : of) check("sigma", *each.sigma, rules::sigma);
  }

  bool one_of(std::span<const UnitKey> units, QuantityInUnit& value, Absent absent) override {
    quantity(units[value.unit].key, value.value, units[value.unit].rule, absent);
    return false;
  }

  void ground_motion(const GroundMotionReading&, const std::optional<Strength>&, Recorded& recorded) override {
    const GroundMotion* motion = recorded.ground_motion.get();
    if (motion == nullptr) return report("file", "", {"is missing", "give a ground motion"});
    if (!rules::gravity.allows(gravity_) || sound_->contains({motion, gravity_})) return;
    const std::size_t problems_before = problems_->size();
    check_ground_motion(motion->samples, gravity_, *problems_);
    if (problems_->size() == problems_before) sound_->insert({motion, gravity_});
  }

  void object(const Key& key, Absent, const Part& part) override {
    const std::size_t length = place_.size();
    (place_ += key.name) += '/';
    part(*this);
    place_.resize(length);
  }
  void number_or_object(const Key& key, bool is_object, const Part& number, const Part& with_more) override {
    if (!is_object) return number(*this);
    object(key, Absent::standard, with_more);
  }
  void kinds(const Key&, std::span<const std::string_view>, std::size_t kind,
             const std::function<void(Keys&, std::size_t)>& part) override {
    part(*this, kind);
  }

 private:
  void check(std::string_view key, double value, const NumberRule& rule) {
    if (!rule.allows(value)) report(key, base::shortest(value), {std::string(rule.demand), rule.remedy()});
  }
  void report(std::string_view key, std::string value, Refusal refusal) {
    problems_->push_back(
        {place_ + std::string(key), std::move(value), std::move(refusal.reason), std::move(refusal.remedy)});
  }

  std::string place_ = "/";
  double gravity_;
  SoundGroundMotions* sound_;
  Problems* problems_;
};

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

std::string text_of(const Quantity& quantity) {
  if (const auto* number = std::get_if<double>(&quantity)) return base::shortest(*number);
  const auto [least, largest] = reach_of(quantity);
  return std::string(law_names[quantity.index() - 1]) + " from " + base::shortest(least) + " to " +
         base::shortest(largest);
}

void check_numbers(const Condition& condition, SoundGroundMotions& sound, Problems& problems) {
  Question question{.title = {}, .seed = 0, .condition = condition};
  CheckingKeys keys(condition.scene.block.gravity, sound, problems);
  keys_of(keys, question);
}

}  // namespace rocking
