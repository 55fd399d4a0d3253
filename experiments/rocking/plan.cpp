#include "plan.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "output.hpp"
#include "rocking/experiment/work.hpp"

namespace rocking::program {
namespace {

using experiment::Scene;

bool is_drawn(const experiment::Quantity& quantity) { return !std::holds_alternative<double>(quantity); }

struct Effect {
  const char* name;
  bool (*is_on)(const Scene&);
};

constexpr std::array<Effect, 9> effects{{
    {"sliding", [](const Scene& s) { return s.friction.has_value(); }},
    {"static friction drawn at each stop",
     [](const Scene& s) { return s.friction && s.fluctuation.static_friction > 0.0; }},
    {"kinetic friction drawn on a grid in time",
     [](const Scene& s) { return s.friction && s.fluctuation.kinetic_friction > 0.0; }},
    {"restitution drawn at each impact", [](const Scene& s) { return s.fluctuation.restitution > 0.0; }},
    {"amplitude drawn each period", [](const Scene& s) { return s.fluctuation.amplitude > 0.0; }},
    {"phase drawn once", [](const Scene& s) { return is_drawn(start_phase(s.excitation)); }},
    {"initial tilt drawn once", [](const Scene& s) { return is_drawn(s.initial.tilt); }},
    {"initial tilt rate drawn once", [](const Scene& s) { return is_drawn(s.initial.tilt_rate); }},
    {"initial slip rate drawn once", [](const Scene& s) { return is_drawn(s.initial.slip_rate); }},
}};

}  // namespace

Plan plan_of(const experiment::Experiment& experiment, const Means& means) {
  Plan plan;
  plan.title = experiment.title;
  plan.conditions = experiment.conditions.size();
  for (const experiment::Condition& condition : experiment.conditions) {
    const std::uint64_t realisations = effective_realisations(condition);
    plan.realisations += realisations;
    plan.at_most = plan.at_most || condition.until;
    plan.has_record = plan.has_record || !is_periodic(condition.scene.excitation);
    const auto [transient, sampled] = condition.horizon;
    plan.periods += realisations * (static_cast<std::uint64_t>(transient) + static_cast<std::uint64_t>(sampled));
  }
  plan.needs = needs_of(experiment, means);
  for (const experiment::Condition& condition : experiment.conditions) {
    for (const std::string_view name :
         std::visit([](const auto& kind) { return kind.effects(); }, condition.scene.excitation)) {
      if (std::ranges::find(plan.effects, name) == plan.effects.end()) plan.effects.emplace_back(name);
    }
  }
  for (const Effect& effect : effects) {
    for (const experiment::Condition& condition : experiment.conditions) {
      if (!effect.is_on(condition.scene)) continue;
      plan.effects.emplace_back(effect.name);
      break;
    }
  }
  return plan;
}

std::string to_text(const Plan& plan) {
  std::string text = plan.title.empty() ? "" : plan.title + '\n';
  text += fmt::format("{}, {}{}, {} of the {}\n", counted(plan.conditions, "condition"), plan.at_most ? "at most " : "",
                      counted(plan.realisations, "realisation"), counted(plan.periods, "period"),
                      plan.has_record ? "strobe" : "excitation");
  text += fmt::format("{} {} of disk space, {} of memory\n", plan.at_most ? "at most" : "about",
                      spoken_size(plan.needs.disk_bytes), spoken_size(plan.needs.memory_bytes));
  if (plan.effects.empty()) return text + "rocking only: no sliding, and nothing is random\n";
  text += "in addition to rocking:\n";
  for (const std::string& effect : plan.effects) text += "  " + effect + '\n';
  return text;
}

std::vector<report::Fact> facts_of(const Plan& plan) {
  return {{"title", plan.title},
          {"conditions", plan.conditions},
          {"realisations", plan.realisations},
          {"periods", plan.periods},
          {"disk_bytes", plan.needs.disk_bytes},
          {"memory_bytes", plan.needs.memory_bytes},
          {"effects", plan.effects}};
}

}  // namespace rocking::program
