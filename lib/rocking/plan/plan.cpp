#include "rocking/plan/plan.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/ensemble/work_list.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"

namespace rocking {
namespace {

/// Processor time of a period in a later window over that of a period of the fixed horizon, at most: there is an exponent
/// in every window, and none in the transient periods.
constexpr double most_cost_of_window = 2.0;

/// An effect, and whether a scene has it.
struct Effect {
  std::string_view name;
  bool is_on;
};

/// Whether a part of the scene is drawn once for each realisation.
template <class... Quantities>
bool is_any_drawn(const Quantities&... quantities) {
  return (is_drawn(quantities) || ...);
}

bool has_vertical_motion(const Excitation& excitation) {
  if (vertical_of(excitation) != nullptr) return true;
  const auto* recorded = std::get_if<Recorded>(&excitation);
  return recorded != nullptr && recorded->ground_motion && recorded->ground_motion->has_vertical;
}

// A member that these two functions do not name does not compile: each is an effect, or is none.

/// What a scene may be simulated with beside its excitation, whatever is drawn once.
std::array<Effect, 8> effects_of(const Scene& scene) {
  const auto& [block, slide_inertia, impact_slip_rule, restitution, excitation, friction, fluctuation, initial] = scene;
  const auto& [of_static, of_kinetic, refreshes, refresh_slip, of_restitution, of_amplitude, laws, correlation] =
      fluctuation;
  const bool of_place = refresh_slip.has_value();
  const bool draws_static = friction && of_static > 0.0;
  const bool draws_kinetic = friction && of_kinetic > 0.0;
  const bool is_once = amplitude_draws(excitation) == AmplitudeDraws::once;
  return {{{"sliding", friction.has_value()},
           {"static friction drawn at each stop", draws_static && !of_place},
           {"static friction drawn for each cell of the slip", draws_static && of_place},
           {"kinetic friction drawn on a grid in time", draws_kinetic && !of_place},
           {"kinetic friction drawn for each cell of the slip", draws_kinetic && of_place},
           {"restitution drawn at each impact", of_restitution > 0.0},
           {"amplitude drawn each period", of_amplitude > 0.0 && !is_once},
           {"amplitude drawn once", of_amplitude > 0.0 && is_once}}};
}

/// Effects that a scene may have, in the words of those who miss them.
std::array<Effect, 6> optional_effects_of(const Scene& scene) {
  const auto& [block, slide_inertia, impact_slip_rule, restitution, excitation, friction, fluctuation, initial] = scene;
  const auto is_drawn_number = [](const RestitutionNumber& e) { return e.value != nullptr && is_drawn(*e.value); };
  const bool draws_rebound = std::ranges::any_of(numbers_of(restitution), is_drawn_number);
  // Without friction nothing is to scatter.
  const bool scatters_friction = !friction || fluctuation.static_friction > 0.0 || fluctuation.kinetic_friction > 0.0 ||
                                 is_any_drawn(friction->static_coefficient, friction->kinetic_coefficient);
  return {{{"sliding", friction.has_value()},
           {"scatter of friction", scatters_friction},
           {"scatter of restitution", fluctuation.restitution > 0.0 || draws_rebound},
           {"scatter of the amplitude", fluctuation.amplitude > 0.0},
           {"scatter of the block's size", is_drawn(block)},
           {"vertical motion of the base", has_vertical_motion(excitation)}}};
}

/// Names of the effects that some condition has, or that none has.
template <std::size_t size>
std::vector<std::string> names_of(const Experiment& experiment, std::array<Effect, size> (*effects)(const Scene&),
                                  bool are_on) {
  std::array<Effect, size> of_some = effects(experiment.conditions.front().scene);
  for (const Condition& condition : experiment.conditions) {
    const std::array<Effect, size> own = effects(condition.scene);
    for (std::size_t i = 0; i < size; ++i) of_some[i].is_on = of_some[i].is_on || own[i].is_on;
  }
  std::vector<std::string> names;
  for (const Effect& effect : of_some) {
    if (effect.is_on == are_on) names.emplace_back(effect.name);
  }
  return names;
}

/// Every quantity that some condition draws, each once.
void add_drawn_quantities(const Experiment& experiment, std::vector<std::string>& names) {
  for (const Condition& condition : experiment.conditions) {
    for (const NamedPlace& each : drawn_once(condition.scene)) {
      const std::string effect = std::string(each.name) + " drawn once";
      if (std::ranges::find(names, effect) == names.end()) names.push_back(effect);
    }
  }
}

}  // namespace

Plan plan_of(const Experiment& experiment, const Means& means) {
  Plan plan;
  plan.title = experiment.title;
  plan.conditions = experiment.conditions.size();
  for (const Condition& condition : experiment.conditions) {
    const std::uint64_t realisations = effective_realisations(condition);
    plan.realisations += realisations;
    plan.at_most = plan.at_most || condition.until;
    plan.has_record = plan.has_record || !is_periodic(condition.scene.excitation);
    const auto transient = condition.horizon.transient_periods;
    const auto sampled = condition.horizon.sampled_periods;
    const auto fixed = static_cast<std::uint64_t>(transient) + static_cast<std::uint64_t>(sampled);
    plan.periods += realisations * fixed;
    const auto& until = condition.horizon.until_classified;
    const auto limit = until ? std::max(fixed, static_cast<std::uint64_t>(until->at_most_periods)) : fixed;
    const auto windows = until ? until->held_windows - 1 + until->watch_windows : 0;
    const auto watched = fixed + static_cast<std::uint64_t>(windows) * static_cast<std::uint64_t>(sampled);
    plan.most_periods += realisations * limit;
    plan.least_periods += realisations * std::min(limit, watched);
  }
  plan.needs = needs_of(experiment, means);
  for (const Condition& condition : experiment.conditions) {
    for (const std::string_view name :
         std::visit([](const auto& kind) { return kind.effects(); }, condition.scene.excitation)) {
      if (std::ranges::find(plan.effects, name) == plan.effects.end()) plan.effects.emplace_back(name);
    }
  }
  for (std::string& name : names_of(experiment, effects_of, true)) plan.effects.push_back(std::move(name));
  add_drawn_quantities(experiment, plan.effects);
  RateRatios ratios;
  for (const Condition& condition : experiment.conditions) ratios.add(condition.scene);
  plan.impacts = ratios.text();
  plan.thresholds = thresholds_text(experiment);
  plan.omitted = names_of(experiment, optional_effects_of, false);
  return plan;
}

double seconds_if_continued(const Plan& plan, double share) {
  const auto fixed = static_cast<double>(plan.periods);
  const double continued =
      share * static_cast<double>(plan.most_periods) + (1.0 - share) * static_cast<double>(plan.least_periods);
  return plan.time->seconds * (1.0 + most_cost_of_window * (continued - fixed) / fixed);
}

}  // namespace rocking
