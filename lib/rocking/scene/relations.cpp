
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

std::string shown(double number) { return base::significant(number, 6); }

/// The smallest limit over a range of shapes.
double painleve_friction(const ShapeRange& shapes, dynamics::SlideInertia inertia) {
  const auto& [slender, squat, least_tangents] = shapes;
  const double at_ends =
      std::min(dynamics::painleve_friction(slender, inertia), dynamics::painleve_friction(squat, inertia));
  // The limit of impacts, 1/(3 tan(psi)) + (4/3) tan(psi), is smallest at tan(psi) = 1/2: 4/3.
  return slender.tangent < 0.5 && squat.tangent > 0.5 ? std::min(at_ends, 4.0 / 3.0) : at_ends;
}

std::optional<Refusal> impossible_body(const Condition& condition) { return refusal_of(condition.scene.block); }

bool is_rectangle(const Condition& condition) {
  const ShapeRange shapes = shapes_of(condition.scene.block);
  return shapes.most_slender.is_rectangle() && shapes.squattest.is_rectangle();
}

std::optional<Refusal> jy25_of_no_rectangle(const Condition& condition) {
  if (!std::holds_alternative<Jy25Restitution>(condition.scene.restitution) || is_rectangle(condition)) {
    return std::nullopt;
  }
  return Refusal{"is a formula for uniform rectangles",
                 "give the restitution e, such as 0.0, or {\"rate_ratio\": 0.9}"};
}

std::optional<Refusal> slide_inertia_of_no_rectangle(const Condition& condition) {
  if (condition.scene.slide_inertia == dynamics::SlideInertia::centroidal || is_rectangle(condition)) {
    return std::nullopt;
  }
  return Refusal{"is a reading of the equations of uniform rectangles",
                 "leave it out, and write \"formulation\": \"consistent\""};
}

std::optional<Refusal> order_of_friction(const Condition& condition) {
  if (!condition.scene.friction) return std::nullopt;
  const double at_rest = mean_static(*condition.scene.friction);
  const double sliding = mean_kinetic(*condition.scene.friction);
  if (at_rest >= sliding) return std::nullopt;
  return Refusal{
      "is below the kinetic coefficient, " + shown(sliding) + ", so that the onset of sliding is not consistent",
      "give at least " + shown(sliding) + ", or lower \"kinetic\""};
}

std::optional<Refusal> painleve(const Condition& condition) {
  const Scene& scene = condition.scene;
  if (!scene.friction) return std::nullopt;
  const double limit = painleve_friction(shapes_of(scene.block), scene.slide_inertia);
  if (mean_kinetic(*scene.friction) < limit) return std::nullopt;
  return Refusal{"is so large that the equations of sliding have no valid solution (Painleve's paradox)",
                 "give less than " + shown(limit) + " for this block and formulation"};
}

std::optional<Refusal> tilt_of_overturned(const Condition& condition) {
  const InitialState& initial = condition.scene.initial;
  const dynamics::Geometry squat = shapes_of(condition.scene.block).squattest;
  const double psi = std::max(squat.edges[0].shape_angle, squat.edges[1].shape_angle);
  const double overturned = 0.5 * std::numbers::pi / tilt_unit(initial.units.tilt, psi);
  const auto [least, largest] = reach_of(initial.tilt);
  if (std::max(std::abs(least), std::abs(largest)) < overturned) return std::nullopt;
  const auto [limit, unit] = std::array<std::array<const char*, 2>, 3>{
      {{"tilt) must be below pi/2/psi = ", "units of the shape angle"},
       {"tilt_rad) must be below pi/2 = ", "rad"},
       {"tilt_deg) must be below ", "degrees"}}}[static_cast<std::size_t>(initial.units.tilt)];
  return Refusal{std::string("reaches the tilt of an overturned block: abs(") + limit + shown(overturned),
                 std::string("give a smaller tilt, in ") + unit};
}

std::optional<Refusal> tilt_beyond_balance(const Condition& condition) {
  if (condition.horizon.until != MotionEnd::balance) return std::nullopt;
  const InitialState& initial = condition.scene.initial;
  const double psi = shapes_of(condition.scene.block).most_slender.shape_angle;
  const double balance = psi / tilt_unit(initial.units.tilt, psi);
  const auto [least, largest] = reach_of(initial.tilt);
  if (std::max(std::abs(least), std::abs(largest)) < balance) return std::nullopt;
  return Refusal{"reaches the balance, at which \"until\": \"balance\" ends the motion",
                 "give less than " + shown(balance) + ", or remove \"until\""};
}

template <Quantity InitialState::*slip>
std::optional<Refusal> slip_without_friction(const Condition& condition) {
  const auto* number = std::get_if<double>(&(condition.scene.initial.*slip));
  if (condition.scene.friction || (number != nullptr && *number == 0.0)) return std::nullopt;
  return Refusal{"the block cannot slide, because the file has no friction",
                 std::string("add \"friction\": {\"static\": 0.35, \"kinetic\": 0.30}, or remove the ") +
                     (slip == &InitialState::slip ? "slip" : "slip rate")};
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

std::optional<Refusal> correlation_beyond_bounds(const Condition& condition) {
  if (rules::correlation.allows(condition.scene.fluctuation.friction_correlation)) return std::nullopt;
  return Refusal{std::string(rules::correlation.demand), "give a number such as 0.5"};
}

std::optional<Refusal> lognormal_without_mean(FluctuationLaw law, double sigma, const std::optional<double>& mean) {
  if (law != FluctuationLaw::lognormal || sigma == 0.0) return std::nullopt;
  if (mean && *mean > 0.0 && sigma <= 100.0 * *mean) return std::nullopt;
  return Refusal{"lognormal needs a positive mean, of at least a hundredth of the standard deviation",
                 "give such a mean, or another law"};
}

template <FluctuationLaw FluctuationLaws::*law, double Fluctuation::*sigma, double (*mean)(const Friction&)>
std::optional<Refusal> lognormal_friction(const Condition& condition) {
  const Fluctuation& f = condition.scene.fluctuation;
  const auto& friction = condition.scene.friction;
  return lognormal_without_mean(f.laws.*law, f.*sigma, friction ? std::optional(mean(*friction)) : std::nullopt);
}

std::optional<Refusal> lognormal_restitution(const Condition& condition) {
  const Fluctuation& f = condition.scene.fluctuation;
  return lognormal_without_mean(f.laws.restitution, f.restitution, lognormal_mean(condition.scene.restitution));
}

std::optional<Refusal> lognormal_amplitude(const Condition& condition) {
  const Fluctuation& f = condition.scene.fluctuation;
  return lognormal_without_mean(f.laws.amplitude, f.amplitude, size_of(condition.scene.excitation));
}

/// Calls use(part) with the horizontal or the vertical part of an excitation that has an amplitude and a frequency.
template <bool vertical, class Use>
auto with_part(const Scene& scene, const Use& use) -> decltype(use(VerticalHarmonic{})) {
  if constexpr (vertical) {
    if (const VerticalHarmonic* part = vertical_of(scene.excitation)) return use(*part);
  } else {
    if (const auto* harmonic = std::get_if<Harmonic>(&scene.excitation)) return use(*harmonic);
    if (const auto* pulse = std::get_if<Pulse>(&scene.excitation)) return use(*pulse);
  }
  return std::nullopt;
}

template <bool vertical>
std::optional<PhysicalAmplitude> physical_amplitude(const Scene& scene) {
  return with_part<vertical>(scene, [](const auto& part) { return part.physical_amplitude; });
}

template <bool vertical>
std::optional<PhysicalFrequency> physical_frequency(const Scene& scene) {
  return with_part<vertical>(scene, [](const auto& part) { return part.physical_frequency; });
}

/// The amplitude that is the largest A_h of the most slender block, in the unit in which it is given.
double largest_amplitude(const Scene& scene) {
  return rules::largest_amplitude * amplitude_unit(scene, shapes_of(scene.block).most_slender);
}

template <bool vertical>
std::optional<Refusal> amplitude_beyond_bounds(const Condition& condition) {
  const Scene& scene = condition.scene;
  const auto asked = physical_amplitude<vertical>(scene);
  if (!asked) return std::nullopt;
  const double amplitude = reach_of(asked->value).largest;
  const double largest =
      rules::largest_amplitude * amplitude_unit(asked, shapes_of(scene.block).most_slender, scene.block.gravity);
  if (amplitude <= largest) return std::nullopt;
  return Refusal{std::string("makes ") + (vertical ? "A_v" : "A_h") + " = " +
                     shown(amplitude / largest * rules::largest_amplitude) + " for this block, above 1e6",
                 "give at most " + shown(largest)};
}

std::optional<Refusal> amplitude_sigma_beyond_bounds(const Condition& condition) {
  const double largest = largest_amplitude(condition.scene);
  if (condition.scene.fluctuation.amplitude <= largest) return std::nullopt;
  return Refusal{"makes a standard deviation of A_h above 1e6 for this block",
                 "give a standard deviation of at most " + shown(largest)};
}

/// Reach of Omega over all blocks.
Reach frequencies_of(const PhysicalFrequency& physical, const SceneBlock& block) {
  const auto [smallest, largest] = sizes_of(block);
  const auto [least, most] = reach_of(physical.value);
  const auto at = [unit = physical.unit](double value, const dynamics::Geometry& own) {
    return frequency_ratio({.value = value, .unit = unit}, own);
  };
  return physical.unit == FrequencyUnit::hertz ? Reach{at(least, largest), at(most, smallest)}
                                               : Reach{at(most, largest), at(least, smallest)};
}

template <bool vertical>
std::optional<Refusal> frequency_beyond_bounds(const Condition& condition) {
  const auto asked = physical_frequency<vertical>(condition.scene);
  if (!asked) return std::nullopt;
  if (reach_of(asked->value).least <= 0.0) {
    return Refusal{"may be zero or negative", "add \"between\" to the law, or write a lognormal one"};
  }
  const auto [low, high] = frequencies_of(*asked, condition.scene.block);
  if (rules::frequency_ratio.allows(low) && rules::frequency_ratio.allows(high)) return std::nullopt;
  constexpr double two_pi = 2.0 * std::numbers::pi;
  const auto [smallest, largest] = sizes_of(condition.scene.block);
  const double least = rules::least_frequency_ratio * smallest.frequency_parameter / two_pi;
  const double most = rules::largest_frequency_ratio * largest.frequency_parameter / two_pi;
  const bool in_hertz = asked->unit == FrequencyUnit::hertz;
  return Refusal{std::string("makes ") + (vertical ? "Omega_v" : "Omega_h") + " = " +
                     shown(rules::frequency_ratio.allows(low) ? high : low) +
                     " for this block, which must lie from 0.001 to 1e6",
                 "give from " + shown(in_hertz ? least : 1.0 / most) + " to " + shown(in_hertz ? most : 1.0 / least)};
}

std::optional<Refusal> part_of_a_cycle(const Condition& condition) {
  const auto* pulse = std::get_if<Pulse>(&condition.scene.excitation);
  if (pulse == nullptr || pulse->shape != dynamics::PulseShape::type_c || std::floor(pulse->cycles) == pulse->cycles) {
    return std::nullopt;
  }
  return Refusal{"must be a whole number: no other pulse of type C ends with velocity and displacement 0",
                 "give 1 or 2"};
}

std::optional<Refusal> vertical_too_fast(const Condition& condition) {
  const VerticalHarmonic* vertical = vertical_of(condition.scene.excitation);
  if (vertical == nullptr) return std::nullopt;
  const auto reach = [&block = condition.scene.block](const auto& part) {
    return part.physical_frequency ? frequencies_of(*part.physical_frequency, block) : reach_of(part.frequency_ratio);
  };
  const double slowest = reach(std::get<Harmonic>(condition.scene.excitation)).least;
  const double fastest = reach(*vertical).largest;
  constexpr double most = 1e4;
  if (fastest <= most * slowest) return std::nullopt;
  return Refusal{"is more than 1e4 times the horizontal frequency, so that too many steps fall in an excitation period",
                 "give at most 1e4 times the horizontal frequency"};
}

template <bool vertical>
std::string_view place_of_frequency(const Condition& condition) {
  const auto& units = vertical ? quantities::vertical_frequencies : quantities::frequencies;
  return quantities::in_unit_of(physical_frequency<vertical>(condition.scene), units).place;
}

std::string vertical_frequency_text(const Condition& condition) {
  const VerticalHarmonic& vertical = *vertical_of(condition.scene.excitation);
  return text_of(vertical.physical_frequency ? vertical.physical_frequency->value : vertical.frequency_ratio);
}

template <std::size_t number>
std::optional<Refusal> restitution_beyond_bounds(const Condition& condition) {
  return refusal_of(condition.scene, number);
}

std::optional<Refusal> until_classified_without_period(const Condition& condition) {
  if (!condition.horizon.until_classified || is_periodic(condition.scene.excitation)) return std::nullopt;
  return Refusal{"continues the windows of a periodic excitation, and this one has an end", "remove it"};
}

std::optional<Refusal> until_classified_without_loss(const Condition& condition) {
  if (!condition.horizon.until_classified || impacts_take_energy(condition.scene)) return std::nullopt;
  return Refusal{"waits until a response has settled; at a rate ratio of 1 impacts take nothing, so that none does",
                 "remove it, or give a rate ratio below 1"};
}

std::optional<Refusal> until_classified_too_short(const Condition& condition) {
  const Horizon& horizon = condition.horizon;
  const std::int64_t fixed = horizon.periods();
  if (!horizon.until_classified || horizon.until_classified->at_most_periods >= fixed) return std::nullopt;
  return Refusal{"is less than the transient and sampled periods, " + std::to_string(fixed),
                 "give at least " + std::to_string(fixed + horizon.sampled_periods) + ", one window more"};
}

std::optional<Refusal> friction_at_wall(const Condition& condition) {
  if (!condition.scene.friction || !condition.scene.block.wall) return std::nullopt;
  return Refusal{"stands beside a wall, away from which a block would slide with a second contact that is not modelled",
                 "omit it: a block at a wall does not slide"};
}

std::optional<Refusal> wall_without_ratio(const Condition& condition) {
  if (condition.scene.block.wall.has_value() == std::holds_alternative<WallRatio>(condition.scene.restitution)) {
    return std::nullopt;
  }
  return Refusal{"and the law of the restitution do not belong together", "give a wall a WallRatio, and only a wall"};
}

/// A start behind the wall, or that moves into it.
template <Quantity InitialState::*number>
std::optional<Refusal> start_in_wall(const Condition& condition) {
  const SceneBlock& block = condition.scene.block;
  if (!block.wall) return std::nullopt;
  const bool is_tilt = number == &InitialState::tilt;
  const Reach tilt = reach_of(condition.scene.initial.tilt), own = reach_of(condition.scene.initial.*number);
  const bool is_wall_right = *block.wall == dynamics::Side::right;
  const bool is_into = is_wall_right ? own.least < 0.0 : own.largest > 0.0;
  if (!is_into || (!is_tilt && !(tilt.least <= 0.0 && tilt.largest >= 0.0))) return std::nullopt;
  return Refusal{std::string("turns the block into the wall at its ") + (is_wall_right ? "right" : "left"),
                 std::string("give a number that is not ") + (is_wall_right ? "negative" : "positive")};
}

/// A drawn number of a building that may be outside its bounds. Laws without bounds are given those by the file.
std::optional<Refusal> building_beyond_bounds(const Condition& condition) {
  const auto* recorded = std::get_if<Recorded>(&condition.scene.excitation);
  if (recorded == nullptr || !recorded->building) return std::nullopt;
  std::optional<Refusal> refusal;
  quantities::visit_building(*recorded->building, [&](const BuildingNumber& what, const Quantity& number) {
    if (refusal || !is_drawn(number) || what.rule == nullptr) return;
    const auto [least, largest] = reach_of(number);
    if (what.rule->allows(least) && what.rule->allows(largest)) return;
    refusal = Refusal{"has a law of the " + std::string(what.name) + " that reaches from " + shown(least) + " to " +
                          shown(largest) + "; each value " + std::string(what.rule->demand),
                      "give a uniform or a lognormal law, or a normal one with \"between\""};
  });
  return refusal;
}

std::string no_value(const Condition&) { return ""; }

struct Relation {
  std::string_view place;                  ///< of the value that the problem names
  std::array<std::string_view, 5> values;  ///< that it is about, as places; the rest is empty
  std::optional<Refusal> (*refusal)(const Condition&);
  std::string (*value)(const Condition&);
  /// In place of `place`, where it follows from the form of the value; null: it does not.
  std::string_view (*place_of)(const Condition&) = nullptr;
};

template <std::size_t number>
constexpr Relation rate_ratio_of_block{
    "/restitution",
    {"/block", "/restitution"},
    restitution_beyond_bounds<number>,
    [](const Condition& c) { return text_of(*numbers_of(c.scene.restitution)[number].value); },
    [](const Condition& c) { return numbers_of(c.scene.restitution)[number].place; }};

template <bool vertical>
constexpr Relation amplitude_of_block{
    "/excitation",
    {"/block", "/excitation"},
    amplitude_beyond_bounds<vertical>,
    [](const Condition& c) { return base::shortest(mean_of(physical_amplitude<vertical>(c.scene)->value)); },
    [](const Condition& c) {
      const auto& units = vertical ? quantities::vertical_amplitudes : quantities::amplitudes;
      return quantities::in_unit_of(physical_amplitude<vertical>(c.scene), units).place;
    }};

template <bool vertical>
constexpr Relation frequency_of_block{
    "/excitation",
    {"/block", "/excitation"},
    frequency_beyond_bounds<vertical>,
    [](const Condition& c) { return text_of(physical_frequency<vertical>(c.scene)->value); },
    place_of_frequency<vertical>};

/// Of a number of the state at the start.
template <Quantity InitialState::*number, StateUnit InitialUnits::*unit, const auto& units>
constexpr Relation about_start(std::array<std::string_view, 5> values,
                               std::optional<Refusal> (*refusal)(const Condition&)) {
  return {units[0].place, values, refusal, [](const Condition& c) { return text_of(c.scene.initial.*number); },
          [](const Condition& c) { return quantities::in_unit(c.scene.initial.units.*unit, units).place; }};
}
constexpr auto about_tilt = about_start<&InitialState::tilt, &InitialUnits::tilt, quantities::tilts>;
constexpr auto about_tilt_rate =
    about_start<&InitialState::tilt_rate, &InitialUnits::tilt_rate, quantities::tilt_rates>;
constexpr auto about_slip = about_start<&InitialState::slip, &InitialUnits::slip, quantities::slips>;
constexpr auto about_slip_rate =
    about_start<&InitialState::slip_rate, &InitialUnits::slip_rate, quantities::slip_rates>;

/// In the order in which the problems of a file are reported.
constexpr auto all_relations = std::to_array<Relation>({
    {"/block", {"/block"}, impossible_body, no_value},
    {"/restitution", {"/block", "/restitution", "/formulation"}, jy25_of_no_rectangle, no_value},
    {"/slide_inertia", {"/block", "/slide_inertia", "/formulation"}, slide_inertia_of_no_rectangle, no_value},
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
    {"/fluctuation/friction/correlation", {"/fluctuation/friction"}, correlation_beyond_bounds, no_value},
    {"/fluctuation/static_friction/law",
     {"/friction", "/fluctuation/friction", "/fluctuation/static_friction"},
     lognormal_friction<&FluctuationLaws::static_friction, &Fluctuation::static_friction, mean_static>,
     no_value},
    {"/fluctuation/kinetic_friction/law",
     {"/friction", "/fluctuation/friction", "/fluctuation/kinetic_friction"},
     lognormal_friction<&FluctuationLaws::kinetic_friction, &Fluctuation::kinetic_friction, mean_kinetic>,
     no_value},
    {"/fluctuation/restitution/law", {"/restitution", "/fluctuation/restitution"}, lognormal_restitution, no_value},
    {"/fluctuation/amplitude/law", {"/excitation", "/fluctuation/amplitude"}, lognormal_amplitude, no_value},
    {"/realisations/until", {"/realisations"}, relations::one_half_width, no_value},
    {"/realisations/until/mode", {"/realisations"}, relations::relative_half_width_of_every_mode, no_value},
    {"/horizon/until_classified", {"/excitation"}, until_classified_without_period, no_value},
    {"/horizon/until_classified", {"/block", "/restitution"}, until_classified_without_loss, no_value},
    {"/horizon/until_classified/at_most_periods",
     {"/horizon"},
     until_classified_too_short,
     [](const Condition& c) { return std::to_string(c.horizon.until_classified->at_most_periods); }},
    {"/friction/static",
     {"/friction"},
     order_of_friction,
     [](const Condition& c) { return text_of(c.scene.friction->static_coefficient); }},
    {"/friction/kinetic",
     {"/friction", "/block", "/slide_inertia", "/formulation"},
     painleve,
     [](const Condition& c) { return base::shortest(mean_kinetic(*c.scene.friction)); }},
    about_tilt({"/block", "/initial/tilt", "/initial/tilt_rad", "/initial/tilt_deg"}, tilt_of_overturned),
    about_tilt({"/block", "/initial/tilt", "/initial/tilt_rad", "/initial/tilt_deg", "/horizon/until"},
               tilt_beyond_balance),
    {"/friction", {"/friction", "/block/wall"}, friction_at_wall, no_value},
    {"/block/wall", {"/block/wall", "/restitution"}, wall_without_ratio, no_value},
    about_tilt({"/block", "/initial/tilt", "/initial/tilt_rad", "/initial/tilt_deg"},
               start_in_wall<&InitialState::tilt>),
    about_tilt_rate({"/block", "/initial/tilt_rate", "/initial/tilt_rate_rad_s"},
                    start_in_wall<&InitialState::tilt_rate>),
    about_slip({"/initial/slip", "/initial/slip_m"}, slip_without_friction<&InitialState::slip>),
    about_slip_rate({"/initial/slip_rate", "/initial/slip_rate_m_s"}, slip_without_friction<&InitialState::slip_rate>),
    amplitude_of_block<false>,
    frequency_of_block<false>,
    amplitude_of_block<true>,
    frequency_of_block<true>,
    {"/excitation/vertical",
     {"/block", "/excitation"},
     vertical_too_fast,
     vertical_frequency_text,
     place_of_frequency<true>},
    {"/excitation/cycles",
     {"/excitation"},
     part_of_a_cycle,
     [](const Condition& c) { return base::shortest(std::get<Pulse>(c.scene.excitation).cycles); }},
    {"/fluctuation/amplitude",
     {"/block", "/excitation", "/fluctuation/amplitude"},
     amplitude_sigma_beyond_bounds,
     no_value},
    {"/excitation/building", {"/excitation/building"}, building_beyond_bounds, no_value},
    rate_ratio_of_block<0>,
    rate_ratio_of_block<1>,
});

/// Whether a problem of what stands at `place`, or within it, is told.
bool is_reported(const Problems& problems, std::string_view place) {
  return std::any_of(problems.begin(), problems.end(), [place](const base::Problem& problem) {
    return problem.place == place || problem.place.starts_with(std::string(place) + '/');
  });
}

/// Whether the relation may be checked: no problem of one of its values is told.
bool is_open(const Relation& relation, const Problems& problems) {
  return std::none_of(relation.values.begin(), relation.values.end(),
                      [&](std::string_view place) { return !place.empty() && is_reported(problems, place); });
}

}  // namespace

void check_relations(const Condition& condition, Problems& problems) {
  for (const Relation& relation : all_relations) {
    auto refusal = is_open(relation, problems) ? relation.refusal(condition) : std::nullopt;
    if (!refusal) continue;
    const std::string_view place = relation.place_of == nullptr ? relation.place : relation.place_of(condition);
    problems.push_back(
        {std::string(place), relation.value(condition), std::move(refusal->reason), std::move(refusal->remedy)});
  }
}

void check_strobe(const Experiment& experiment) {
  for (const Condition& condition : experiment.conditions) {
    auto refusal = relations::vertical_without_strobe(condition);
    if (!refusal) continue;
    throw base::InputError({.place = std::string(place_of_frequency<true>(condition)),
                            .value = vertical_frequency_text(condition),
                            .reason = std::move(refusal->reason),
                            .remedy = std::move(refusal->remedy)});
  }
}

Refusal relations::no_friction_to_fluctuate() {
  return {"the file has no friction that could fluctuate", "add \"friction\": {\"static\": 0.35, \"kinetic\": 0.30}"};
}

Refusal relations::no_period_to_fluctuate() {
  return {"is redrawn at each period of the excitation, and a ground motion has no periods",
          "sweep \"/excitation/scale\" to vary the size of the motion"};
}

std::optional<Refusal> relations::vertical_without_strobe(const Condition& condition) {
  if (vertical_of(condition.scene.excitation) == nullptr || periods_of_base(condition.scene)) return std::nullopt;
  return Refusal{
      "is neither a whole multiple of the horizontal frequency nor that frequency over a whole number, in every "
      "realisation: a strobe point once an excitation period would find the vertical motion at another phase each "
      "time, so that no response would repeat",
      "give such a frequency, in the same unit as the horizontal one, or look at the motion with `rocking trajectory`"};
}

std::optional<Refusal> relations::one_half_width(const Condition& condition) {
  if (!condition.until || condition.until->half_width.has_value() != condition.until->relative_half_width.has_value()) {
    return std::nullopt;
  }
  return Refusal{condition.until->half_width ? "has two half-widths, of which only one can end a run"
                                             : "has no half-width at which to stop",
                 "give \"half_width\": 0.02, or \"mode\" and \"relative_half_width\": 0.1"};
}

std::optional<Refusal> relations::relative_half_width_of_every_mode(const Condition& condition) {
  if (!condition.until || !condition.until->relative_half_width || condition.until->mode) return std::nullopt;
  return Refusal{"is missing: no half-width is narrow relative to the probability of a mode that does not occur",
                 "add \"mode\": \"overturned\", or another response mode"};
}

}  // namespace rocking
