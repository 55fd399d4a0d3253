#include "rocking/scene/relations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/dynamics/validity.hpp"
#include "rocking/scene/check_numbers.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

std::string shown(double number) { return base::significant(number, 6); }

/// The smallest limit over a range of shapes.
double painleve_friction(const ShapeRange& shapes, dynamics::SlideInertia inertia) {
  const auto& [slender, squat] = shapes;
  const double at_ends =
      std::min(dynamics::painleve_friction(slender, inertia), dynamics::painleve_friction(squat, inertia));
  // The limit of impacts, 1/(3 tan(psi)) + (4/3) tan(psi), is smallest at tan(psi) = 1/2: 4/3.
  return slender.tangent < 0.5 && squat.tangent > 0.5 ? std::min(at_ends, 4.0 / 3.0) : at_ends;
}

std::optional<Refusal> order_of_friction(const Condition& condition) {
  if (!condition.scene.friction) return std::nullopt;
  const auto [at_rest, sliding] = *condition.scene.friction;
  if (at_rest >= sliding) return std::nullopt;
  return Refusal{
      "is below the kinetic coefficient, " + shown(sliding) + ", so that the onset of sliding is not consistent",
      "give at least " + shown(sliding) + ", or lower \"kinetic\""};
}

std::optional<Refusal> painleve(const Condition& condition) {
  const Scene& scene = condition.scene;
  if (!scene.friction) return std::nullopt;
  const double limit = painleve_friction(shapes_of(scene.block), scene.slide_inertia);
  if (scene.friction->kinetic_coefficient < limit) return std::nullopt;
  return Refusal{"is so large that the equations of sliding have no valid solution (Painleve's paradox)",
                 "give less than " + shown(limit) + " for this block and formulation"};
}

std::optional<Refusal> tilt_of_overturned(const Condition& condition) {
  const double psi = shapes_of(condition.scene.block).squattest.shape_angle;
  const double overturned = 0.5 * std::numbers::pi / psi;
  const auto [least, largest] = reach_of(condition.scene.initial.tilt);
  if (std::max(std::abs(least), std::abs(largest)) < overturned) return std::nullopt;
  return Refusal{"reaches the tilt of an overturned block: abs(tilt) must be below pi/2/psi = " + shown(overturned),
                 "give a smaller tilt, in units of the shape angle"};
}

std::optional<Refusal> slip_without_friction(const Condition& condition) {
  const auto* number = std::get_if<double>(&condition.scene.initial.slip_rate);
  if (condition.scene.friction || (number != nullptr && *number == 0.0)) return std::nullopt;
  return Refusal{"the block cannot slide, because the file has no friction",
                 "add \"friction\": {\"static\": 0.35, \"kinetic\": 0.30}, or remove the slip rate"};
}

std::optional<Refusal> static_fluctuation_without_friction(const Condition& condition) {
  if (condition.scene.friction || condition.scene.fluctuation.static_friction == 0.0) return std::nullopt;
  return relations::no_friction_to_fluctuate();
}

std::optional<Refusal> kinetic_fluctuation_without_friction(const Condition& condition) {
  if (condition.scene.friction || condition.scene.fluctuation.kinetic_friction == 0.0) return std::nullopt;
  return relations::no_friction_to_fluctuate();
}

std::optional<Refusal> fluctuating_amplitude_without_period(const Condition& condition) {
  const Scene& scene = condition.scene;
  if (amplitude_draws(scene.excitation) != AmplitudeDraws::refused || scene.fluctuation.amplitude == 0.0)
    return std::nullopt;
  return relations::no_period_to_fluctuate();
}

std::string no_value(const Condition&) { return ""; }

struct Relation {
  std::string_view place;                  ///< of the value that is told of
  std::array<std::string_view, 4> values;  ///< that it is about, as places; the rest is empty
  std::optional<Refusal> (*refusal)(const Condition&);
  std::string (*value)(const Condition&);
};

/// In the order in which the problems of a file are told.
constexpr std::array<Relation, 9> all_relations{{
    {"/fluctuation/static_friction",
     {"/friction", "/fluctuation/friction", "/fluctuation/static_friction"},
     static_fluctuation_without_friction,
     no_value},
    {"/fluctuation/kinetic_friction",
     {"/friction", "/fluctuation/friction", "/fluctuation/kinetic_friction"},
     kinetic_fluctuation_without_friction,
     no_value},
    {"/fluctuation/amplitude",
     {"/excitation", "/fluctuation/amplitude"},
     fluctuating_amplitude_without_period,
     no_value},
    {"/check_labels", {}, relations::label_check_of_open_number, no_value},
    {"/check_labels",
     {"/horizon/sampled_periods", "/check_labels/times_longer"},
     relations::label_check_too_long,
     no_value},
    {"/friction/static",
     {"/friction"},
     order_of_friction,
     [](const Condition& c) { return base::shortest(c.scene.friction->static_coefficient); }},
    {"/friction/kinetic",
     {"/friction", "/block", "/slide_inertia", "/formulation"},
     painleve,
     [](const Condition& c) { return base::shortest(c.scene.friction->kinetic_coefficient); }},
    {"/initial/tilt",
     {"/block", "/initial/tilt"},
     tilt_of_overturned,
     [](const Condition& c) { return text_of(c.scene.initial.tilt); }},
    {"/initial/slip_rate",
     {"/initial/slip_rate"},
     slip_without_friction,
     [](const Condition& c) { return text_of(c.scene.initial.slip_rate); }},
}};

/// Whether a problem of what stands at `place`, or within it, is told.
bool is_told(const Problems& problems, std::string_view place) {
  return std::any_of(problems.begin(), problems.end(), [place](const base::Problem& problem) {
    return problem.place == place || problem.place.starts_with(std::string(place) + '/');
  });
}

/// Whether the relation may be checked: no problem of one of its values is told.
bool is_open(const Relation& relation, const Problems& problems) {
  return std::none_of(relation.values.begin(), relation.values.end(),
                      [&](std::string_view place) { return !place.empty() && is_told(problems, place); });
}

/// A reader of files may have told it already, at the key where it met it.
bool holds(const Problems& problems, std::string_view place, const Refusal& refusal) {
  return std::any_of(problems.begin(), problems.end(), [&](const base::Problem& problem) {
    return problem.place == place && problem.reason == refusal.reason;
  });
}

}  // namespace

void check_relations(const Condition& condition, Problems& problems) {
  for (const Relation& relation : all_relations) {
    auto refusal = is_open(relation, problems) ? relation.refusal(condition) : std::nullopt;
    if (!refusal || holds(problems, relation.place, *refusal)) continue;
    problems.push_back({std::string(relation.place), relation.value(condition), std::move(refusal->reason),
                        std::move(refusal->remedy)});
  }
}

Refusal relations::no_friction_to_fluctuate() {
  return {"the file has no friction that could fluctuate", "add \"friction\": {\"static\": 0.35, \"kinetic\": 0.30}"};
}

Refusal relations::no_period_to_fluctuate() {
  return {"is redrawn at each period of the excitation, and a ground motion has no periods",
          "sweep \"/excitation/scale\" to vary the size of the motion"};
}

std::optional<Refusal> relations::label_check_of_open_number(const Condition& condition) {
  if (!condition.label_check || !condition.until) return std::nullopt;
  return Refusal{"has no valid correction if the data determine the number of realisations",
                 "give a number of realisations"};
}

std::optional<Refusal> relations::label_check_too_long(const Condition& condition) {
  if (!condition.label_check) return std::nullopt;
  const std::int64_t longer =
      std::int64_t{condition.horizon.sampled_periods} * static_cast<std::int64_t>(condition.label_check->times_longer);
  if (longer <= rules::sampled_periods.high) return std::nullopt;
  return Refusal{"would sample " + std::to_string(longer) + " periods", "lower \"times_longer\""};
}

}  // namespace rocking
