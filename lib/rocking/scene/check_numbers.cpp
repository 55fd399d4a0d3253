#include "rocking/scene/check_numbers.hpp"

#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/scene/check_ground_motion.hpp"
#include "rocking/scene/experiment_keys.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

class CheckingKeys final : public Keys {
 public:
  CheckingKeys(double gravity, SoundGroundMotions& sound, Problems& problems)
      : gravity_(gravity), sound_(&sound), problems_(&problems) {}

  void text(const Key&, std::string&) override {}
  void word(const Key&, std::size_t&, std::span<const std::string_view>, Absent) override {}
  void mode(const Key&, std::optional<section::ResponseMode>&) override {}
  void seed(const Key&, std::uint64_t&) override {}
  void sweep(const Key&) override {}
  void record_format(const Key&, std::optional<RecordFormat>&) override {}
  void file(const Key&, const Key&, std::string&) override {}
  bool suite(const Key&) override { return true; }
  bool stands(std::string_view, bool is_given) override { return is_given; }

  void number(const Key& key, double& value, const NumberRule& rule, Absent) override { check(key.name, value, rule); }

  void whole_number(const Key& key, std::int64_t& value, const IntegerRule& rule, Absent) override {
    if (!rule.allows(value)) report(key.name, std::to_string(value), {rule.demand(), rule.remedy()});
  }

  void quantity(const Key& key, Quantity& quantity, const NumberRule& rule, Absent) override {
    const std::string name(key.name);
    if (const auto* number = std::get_if<double>(&quantity)) return check(name, *number, rule);
    if (const auto* normal = std::get_if<Normal>(&quantity)) {
      check(name + "/normal/mean", normal->mean, rule);
      check(name + "/normal/sigma", normal->sigma, rules::sigma);
      return;
    }
    const auto& uniform = std::get<Uniform>(quantity);
    check(name + "/uniform/0", uniform.low, rule);
    check(name + "/uniform/1", uniform.high, rule);
    if (!rule.allows(uniform.low) || !rule.allows(uniform.high)) return;
    if (auto refusal = refuse_ends(uniform)) {
      report(name + "/uniform", '[' + base::shortest(uniform.low) + ',' + base::shortest(uniform.high) + ']', *refusal);
    }
  }

  void restitution(const Key& key, Restitution& value, Absent) override {
    if (const auto* number = std::get_if<double>(&value)) check(key.name, *number, rules::restitution);
    if (const auto* ratio = std::get_if<RateRatio>(&value)) {
      check(std::string(key.name) + "/rate_ratio", ratio->value, rules::rate_ratio);
    }
  }

  void scatter(std::initializer_list<Scatter> of) override {
    for (const Scatter& each : of) check("sigma", *each.sigma, rules::sigma);
  }

  bool one_of(std::span<const UnitKey> units, NumberInUnit& value, Absent) override {
    check(units[value.unit].key.name, value.value, units[value.unit].rule);
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

std::optional<Refusal> refuse_ends(const Uniform& law) {
  if (law.low < law.high) return std::nullopt;
  return Refusal{"its first end must be less than its second", "swap them, or write a number"};
}

std::string text_of(const Quantity& quantity) {
  if (const auto* number = std::get_if<double>(&quantity)) return base::shortest(*number);
  if (const auto* uniform = std::get_if<Uniform>(&quantity)) {
    return "{\"uniform\":[" + base::shortest(uniform->low) + ',' + base::shortest(uniform->high) + "]}";
  }
  const auto& normal = std::get<Normal>(quantity);
  return "{\"normal\":{\"mean\":" + base::shortest(normal.mean) + ",\"sigma\":" + base::shortest(normal.sigma) + "}}";
}

void check_numbers(const Condition& condition, SoundGroundMotions& sound, Problems& problems) {
  Question question{.title = {}, .seed = 0, .condition = condition};
  CheckingKeys keys(condition.scene.block.gravity, sound, problems);
  keys_of(keys, question);
}

}  // namespace rocking
