#include "rocking/plan/plan.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "rocking/ensemble/work_list.hpp"
#include "rocking/plan/thresholds.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/rate_ratios.hpp"

namespace rocking {
namespace {

/// Processor time of a period in a later window over that of a period of the fixed horizon, at most: there is an exponent
/// in every window, and none in the transient periods.
constexpr double most_cost_of_window = 2.0;

struct Effect {
  const char* name;
  bool (*is_on)(const Scene&);
};

bool belongs_to_the_place(const Scene& s) { return s.fluctuation.refresh_slip_m.has_value(); }

constexpr std::array<Effect, 8> effects{{
    {"sliding", [](const Scene& s) { return s.friction.has_value(); }},
    {"static friction drawn at each stop",
     [](const Scene& s) { return s.friction && s.fluctuation.static_friction > 0.0 && !belongs_to_the_place(s); }},
    {"static friction drawn for each cell of the slip",
     [](const Scene& s) { return s.friction && s.fluctuation.static_friction > 0.0 && belongs_to_the_place(s); }},
    {"kinetic friction drawn on a grid in time",
     [](const Scene& s) { return s.friction && s.fluctuation.kinetic_friction > 0.0 && !belongs_to_the_place(s); }},
    {"kinetic friction drawn for each cell of the slip",
     [](const Scene& s) { return s.friction && s.fluctuation.kinetic_friction > 0.0 && belongs_to_the_place(s); }},
    {"restitution drawn at each impact", [](const Scene& s) { return s.fluctuation.restitution > 0.0; }},
    {"amplitude drawn each period",
     [](const Scene& s) {
       return s.fluctuation.amplitude > 0.0 && amplitude_draws(s.excitation) != AmplitudeDraws::once;
     }},
    {"amplitude drawn once",
     [](const Scene& s) {
       return s.fluctuation.amplitude > 0.0 && amplitude_draws(s.excitation) == AmplitudeDraws::once;
     }},
}};

/// Whether a part of the scene is drawn once for each realisation.
template <class... Quantities>
bool is_any_drawn(const Quantities&... quantities) {
  return (is_drawn(quantities) || ...);
}

bool has_vertical_motion(const Scene& scene) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  return recorded != nullptr && recorded->ground_motion && recorded->ground_motion->has_vertical;
}

/// Effects that an experiment may have, in the words of those who miss them.
constexpr std::array<Effect, 6> optional_effects{{
    {"sliding", [](const Scene& s) { return s.friction.has_value(); }},
    {"scatter of friction",
     [](const Scene& s) {  // without friction nothing is to scatter
       return !s.friction || (s.fluctuation.static_friction > 0.0 || s.fluctuation.kinetic_friction > 0.0 ||
                              is_any_drawn(s.friction->static_coefficient, s.friction->kinetic_coefficient));
     }},
    {"scatter of restitution",
     [](const Scene& s) {
       const auto* number = std::get_if<Quantity>(&s.restitution);
       return s.fluctuation.restitution > 0.0 || (number != nullptr && is_drawn(*number));
     }},
    {"scatter of the amplitude", [](const Scene& s) { return s.fluctuation.amplitude > 0.0; }},
    {"scatter of the block's size", [](const Scene& s) { return is_any_drawn(s.block.width, s.block.height); }},
    {"vertical motion of the base", has_vertical_motion},
}};

std::vector<std::string> omitted_from(const Experiment& experiment) {
  std::vector<std::string> names;
  for (const Effect& effect : optional_effects) {
    const auto is_on = [&effect](const Condition& condition) { return effect.is_on(condition.scene); };
    if (std::ranges::none_of(experiment.conditions, is_on)) names.emplace_back(effect.name);
  }
  return names;
}

/// Every quantity that some condition draws, each once.
void add_drawn_quantities(const Experiment& experiment, std::vector<std::string>& names) {
  for (const Condition& condition : experiment.conditions) {
    for_each_quantity(condition.scene, [&](const QuantityPlace& what, const Quantity& quantity) {
      const std::string effect = std::string(what.name) + " drawn once";
      if (is_drawn(quantity) && std::ranges::find(names, effect) == names.end()) names.push_back(effect);
    });
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
  for (const Effect& effect : effects) {
    for (const Condition& condition : experiment.conditions) {
      if (!effect.is_on(condition.scene)) continue;
      plan.effects.emplace_back(effect.name);
      break;
    }
  }
  add_drawn_quantities(experiment, plan.effects);
  RateRatios ratios;
  for (const Condition& condition : experiment.conditions) {
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
    ratios.add(block, restitution_of(condition.scene, block));
  }
  plan.impacts = ratios.text();
  plan.thresholds = thresholds_text(experiment);
  plan.omitted = omitted_from(experiment);
  return plan;
}

double seconds_if_continued(const Plan& plan, double share) {
  const auto fixed = static_cast<double>(plan.periods);
  const double continued =
      share * static_cast<double>(plan.most_periods) + (1.0 - share) * static_cast<double>(plan.least_periods);
  return plan.time->seconds * (1.0 + most_cost_of_window * (continued - fixed) / fixed);
}

}  // namespace rocking
