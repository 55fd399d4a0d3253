#include <algorithm>
#include <array>
#include <cstddef>
#include <variant>

#include "rocking/ensemble/law_in_force.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// The normal law in which a number scatters along the way; absent if there is no number, or it has another law.
std::optional<stats::MeanAndSigma> normal_law_of(const Quantity* number, double sigma, FluctuationLaw law) {
  const double* mean = number == nullptr ? nullptr : std::get_if<double>(number);
  if (mean == nullptr || !(sigma > 0.0) || law != FluctuationLaw::normal) return std::nullopt;
  return stats::MeanAndSigma{*mean, sigma};
}

std::optional<stats::MeanAndSigma> law_of_static(const Scene& scene) {
  const Quantity* number = scene.friction ? &scene.friction->static_coefficient : nullptr;
  return normal_law_of(number, scene.fluctuation.static_friction, scene.fluctuation.laws.static_friction);
}

std::optional<stats::MeanAndSigma> law_of_kinetic(const Scene& scene) {
  const bool is_given = scene.friction && !scene.friction->kinetic_ratio;
  const Quantity* number = is_given ? &scene.friction->kinetic_coefficient : nullptr;
  return normal_law_of(number, scene.fluctuation.kinetic_friction, scene.fluctuation.laws.kinetic_friction);
}

std::optional<stats::MeanAndSigma> law_of_restitution(const Scene& scene) {
  return normal_law_of(std::get_if<Quantity>(&scene.restitution), scene.fluctuation.restitution,
                       scene.fluctuation.laws.restitution);
}

std::optional<stats::MeanAndSigma> law_of_amplitude(const Scene& scene) {
  const Quantity* number = std::visit(
      []<class Kind>(const Kind& kind) -> const Quantity* {
        if constexpr (requires { kind.physical_amplitude; }) return kind.physical_amplitude ? nullptr : &kind.amplitude;
        return nullptr;
      },
      scene.excitation);
  return normal_law_of(number, scene.fluctuation.amplitude, scene.fluctuation.laws.amplitude);
}

/// What a kind of clamp means.
struct ClampedNumber {
  std::uint64_t Clamps::*count;
  const char* what;
  const char* remedy;
  std::optional<stats::MeanAndSigma> (*law)(const Scene&) = nullptr;  ///< null: none in force is known
};

/// In the order of clamp_kinds.
constexpr std::array<ClampedNumber, clamp_kinds.size()> meanings{{
    {&Clamps::kinetic_at_zero, "kinetic friction below 0",
     "reduce the sigma of its fluctuation or increase /friction/kinetic", law_of_kinetic},
    {&Clamps::kinetic_at_static, "kinetic friction above the static friction in force",
     "add \"correlation\": 1 to /fluctuation/friction, or reduce the sigma of the friction", law_of_kinetic},
    {&Clamps::static_at_zero, "static friction below 0",
     "reduce the sigma of its fluctuation or increase /friction/static", law_of_static},
    {&Clamps::restitution, "restitution outside of its range", "reduce the sigma in /fluctuation/restitution",
     law_of_restitution},
    {&Clamps::amplitude_at_zero, "amplitude below 0", "reduce the sigma in /fluctuation/amplitude", law_of_amplitude},
    {&Clamps::length_at_bound, "width or height of the block outside of its bounds",
     "reduce the sigma of /block/width_m or /block/height_m"},
}};
static_assert(std::ranges::equal(meanings, clamp_kinds, {}, &ClampedNumber::count, &ClampKind::count));

/// What clamps of a kind mean, with what they leave of the law: `kinetic friction below 0, which leaves a mean of 0.348 and
/// a sigma of 0.0274, not 0.35 and 0.03`.
std::string meaning_of(const Scene& scene, std::size_t kind) {
  const ClampedNumber& number = meanings[kind];
  const auto given = number.law == nullptr ? std::nullopt : number.law(scene);
  if (!given) return number.what;
  const auto in_force = law_in_force(
      {.law = *given, .limit = law_of_static(scene), .correlation = scene.fluctuation.friction_correlation},
      clamp_kinds[kind].key);
  if (!in_force) return number.what;
  return std::string(number.what) + ", which leaves a mean of " + significant(in_force->mean, 3) + " and a sigma of " +
         significant(in_force->sigma, 3) + ", not " + significant(given->mean, 3) + " and " +
         significant(given->sigma, 3);
}

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// Of a condition.
struct ClampedShare {
  double of_realisations = 0.0;
  double of_draws = 0.0;
  std::size_t condition = 0;

  [[nodiscard]] bool is_tolerable() const {
    return of_realisations <= tolerable_clamped_share && of_draws <= tolerable_clamped_share;
  }
};

/// The largest that is not tolerable.
std::optional<ClampedShare> worst_share(const Report& report) {
  std::optional<ClampedShare> worst;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const ConditionResult& result = report.conditions[i].result;
    const ClampedShare here{.of_realisations = share(result.validity.clamped.count, result.realisations),
                            .of_draws = share(result.validity.clamps.all(), result.operations.draws()),
                            .condition = i};
    if (!here.is_tolerable() && (!worst || here.of_draws > worst->of_draws)) worst = here;
  }
  return worst;
}

}  // namespace

Finding clamped_numbers(const Report& report) {
  Finding found{.name = "clamped random numbers", .rating = Rating::fine, .text = "no random number was clamped"};
  std::uint64_t realisations = 0;
  for (const ReportedCondition& each : report.conditions) realisations += each.result.validity.clamped.count;
  if (realisations > 0) {
    found.rating = Rating::note;
    found.text = counted(realisations, "realisation") + " had a random number clamped to its range";
  }
  const auto worst = worst_share(report);
  if (!worst) return found;
  const ReportedCondition& condition = report.conditions[worst->condition];
  const auto* const most = std::ranges::max_element(
      clamp_kinds, {}, [&condition](const ClampKind& kind) { return condition.result.validity.clamps.*kind.count; });
  const auto kind = static_cast<std::size_t>(most - clamp_kinds.begin());
  found.rating = Rating::look;
  found.text = per_cent(worst->of_draws) + " % of the draws of condition " + std::to_string(worst->condition) +
               " were clamped, in " + per_cent(worst->of_realisations) + " % of its realisations; mostly " +
               meaning_of(condition.asked.scene, kind);
  found.remedy = meanings[kind].remedy;
  return found;
}

std::vector<Finding> foreseen_clamps(const Experiment& experiment) {
  const std::vector<SampledClamps> sampled = sample_clamps(experiment);
  std::vector<Finding> findings;
  for (std::size_t kind = 0; kind < meanings.size(); ++kind) {
    const auto of_draws = [kind](const SampledClamps& here) {
      return share(here.clamps.*meanings[kind].count, here.realisations);
    };
    const auto worst = std::ranges::max_element(sampled, {}, of_draws);
    if (worst == sampled.end() || of_draws(*worst) <= tolerable_clamped_share) continue;
    const bool is_one = experiment.conditions.size() == 1;
    findings.push_back(
        {.name = "clamped random numbers",
         .text = "random numbers would be clamped in " + significant(100.0 * of_draws(*worst), 2) +
                 " % of their draws" +
                 (is_one ? "" : " in condition " + std::to_string(worst->condition) + ", the most of any") + ": " +
                 meaning_of(experiment.conditions[worst->condition].scene, kind),
         .remedy = meanings[kind].remedy});
  }
  return findings;
}

}  // namespace rocking
