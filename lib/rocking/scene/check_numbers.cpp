#include "rocking/scene/check_numbers.hpp"

#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

void check_fluctuation(const Fluctuation& sigma, const NumberChecker& check) {
  check("/fluctuation/static_friction/sigma", sigma.static_friction, rules::sigma);
  check("/fluctuation/kinetic_friction/sigma", sigma.kinetic_friction, rules::sigma);
  check("/fluctuation/kinetic_friction/refreshes_per_period", sigma.refreshes_per_period,
        rules::refreshes.with_default(Fluctuation{}.refreshes_per_period));
  check("/fluctuation/restitution/sigma", sigma.restitution, rules::sigma);
  check("/fluctuation/amplitude/sigma", sigma.amplitude, rules::sigma);
}

void check_scene_numbers(const Scene& scene, const NumberChecker& check) {
  check("/block/width_m", scene.block.width, rules::length);
  check("/block/height_m", scene.block.height, rules::length);
  check("/block/gravity_m_s2", scene.block.gravity, rules::gravity);
  if (const auto* number = std::get_if<double>(&scene.restitution)) check("/restitution", *number, rules::restitution);
  if (const auto* ratio = std::get_if<RateRatio>(&scene.restitution))
    check("/restitution/rate_ratio", ratio->value, rules::rate_ratio);
  std::visit([&check](const auto& kind) { kind.check(check); }, scene.excitation);
  if (scene.friction) {
    check("/friction/static", scene.friction->static_coefficient, rules::friction_coefficient);
    check("/friction/kinetic", scene.friction->kinetic_coefficient, rules::friction_coefficient);
  }
  check_fluctuation(scene.fluctuation, check);
  check("/initial/tilt", scene.initial.tilt, rules::initial_value);
  check("/initial/tilt_rate", scene.initial.tilt_rate, rules::initial_value);
  check("/initial/slip_rate", scene.initial.slip_rate, rules::initial_value);
}

void check_realisations(const Condition& condition, const NumberChecker& check) {
  if (condition.until) {
    const auto& [half_width, relative, mode] = *condition.until;
    if (half_width) check("/realisations/until/half_width", *half_width, rules::half_width);
    if (relative) check("/realisations/until/relative_half_width", *relative, rules::relative_half_width);
    check("/realisations/until/at_most", condition.realisations, rules::at_most);
  } else {
    check("/realisations", condition.realisations, rules::realisations.with_default(Condition{}.realisations));
  }
  if (!condition.label_check) return;
  check("/check_labels/every", condition.label_check->every, rules::check_every.with_default(LabelCheck{}.every));
  check("/check_labels/times_longer", condition.label_check->times_longer,
        rules::times_longer.with_default(LabelCheck{}.times_longer));
}

}  // namespace

void NumberChecker::operator()(std::string_view place, double value, const NumberRule& rule) const {
  if (rule.allows(value)) return;
  problems_->push_back({std::string(place), base::shortest(value), std::string(rule.demand), rule.remedy()});
}

void NumberChecker::operator()(std::string_view place, const Quantity& quantity, const NumberRule& rule) const {
  if (const auto* number = std::get_if<double>(&quantity)) return (*this)(place, *number, rule);
  const std::string key(place);
  if (const auto* normal = std::get_if<Normal>(&quantity)) {
    (*this)(key + "/normal/mean", normal->mean, rule);
    (*this)(key + "/normal/sigma", normal->sigma, rules::sigma);
    return;
  }
  const auto& uniform = std::get<Uniform>(quantity);
  (*this)(key + "/uniform/0", uniform.low, rule);
  (*this)(key + "/uniform/1", uniform.high, rule);
  if (!rule.allows(uniform.low) || !rule.allows(uniform.high)) return;
  auto refusal = refuse_ends(uniform);
  if (!refusal) return;
  problems_->push_back({key + "/uniform", '[' + base::shortest(uniform.low) + ',' + base::shortest(uniform.high) + ']',
                        std::move(refusal->reason), std::move(refusal->remedy)});
}

void NumberChecker::operator()(std::string_view place, const std::shared_ptr<const GroundMotion>& motion) const {
  if (!motion) {
    problems_->push_back({std::string(place), "", "is missing", "give a ground motion"});
    return;
  }
  if (!rules::gravity.allows(gravity_) || sound_->contains({motion.get(), gravity_})) return;
  const std::size_t problems_before = problems_->size();
  check_ground_motion(motion->samples, gravity_, *problems_);
  if (problems_->size() == problems_before) sound_->insert({motion.get(), gravity_});
}

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
  const NumberChecker check(condition.scene.block.gravity, sound, problems);
  check_scene_numbers(condition.scene, check);
  check("/horizon/transient_periods", condition.horizon.transient_periods,
        rules::transient_periods.with_default(Horizon{}.transient_periods));
  check("/horizon/sampled_periods", condition.horizon.sampled_periods,
        rules::sampled_periods.with_default(Horizon{}.sampled_periods));
  if (const auto& until = condition.horizon.until_classified) {
    check("/horizon/until_classified/at_most_periods", until->at_most_periods, rules::at_most_periods);
    check("/horizon/until_classified/held_windows", until->held_windows, rules::held_windows.with_default(1));
    check("/horizon/until_classified/watch_windows", until->watch_windows, rules::watch_windows.with_default(0));
    check("/horizon/until_classified/long_run_every", until->long_run_every, rules::long_run_every.with_default(0));
    check("/horizon/until_classified/exponent_pause", until->exponent_pause, rules::exponent_pause.with_default(0));
  }
  check("/accuracy/tolerance", condition.tolerance, rules::tolerance);
  check("/accuracy/rerun_every", condition.rerun_every, rules::rerun_every.with_default(Condition{}.rerun_every));
  check_realisations(condition, check);
  check("/confidence", condition.confidence, rules::confidence);
}

}  // namespace rocking
