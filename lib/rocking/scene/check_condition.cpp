#include "rocking/scene/check_condition.hpp"

#include <string>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/fields/field_checker.hpp"
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

/// Motions that come from C++: their samples are checked.
class CheckedRecords final : public RecordFields {
 public:
  CheckedRecords(double gravity, SoundGroundMotions& sound, Problems& problems)
      : gravity_(gravity), sound_(&sound), problems_(&problems) {}

  [[nodiscard]] const ValueType& format_type() const override { return type_of<Json>(); }
  void file(FieldVisitor&, const Key&, const Key&, std::string&) override {}
  bool suite(FieldVisitor&, const Key&) override { return true; }
  void ground_motion(FieldVisitor&, const GroundMotionReading&, const std::optional<Strength>&,
                     Recorded& recorded) override {
    const GroundMotion* motion = recorded.ground_motion.get();
    if (motion == nullptr) {
      return problems_->push_back({"/excitation/file", "", "is missing", "give a ground motion"});
    }
    if (!rules::gravity.allows(gravity_) || sound_->contains({motion, gravity_})) return;
    const std::size_t problems_before = problems_->size();
    check_ground_motion(motion->samples, gravity_, *problems_);
    if (problems_->size() == problems_before) sound_->insert({motion, gravity_});
  }

 private:
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
  UnsweptExperiment question{.title = {}, .seed = 0, .condition = condition};
  FieldChecker checker("", problems);
  CheckedRecords records(condition.scene.block.gravity, sound, problems);
  keys_of(checker, question, records);
}

}  // namespace rocking
