#include "rocking/experiment/reduce.hpp"

#include <algorithm>
#include <map>

#include "rocking/stats/diversity.hpp"
#include "rocking/stats/quantile.hpp"

namespace rocking::experiment {
namespace {

using section::ResponseKind;
using section::ResponseMode;

using Tally = std::map<ResponseMode, std::uint64_t>;

Tally tally_of(std::span<const Summary> realisations) {
  Tally tally{{section::periodic(1, 1), 0},
              {section::periodic(1, 3), 0},
              {{.kind = ResponseKind::chaotic}, 0},
              {{.kind = ResponseKind::overturned}, 0}};
  for (const Summary& summary : realisations) ++tally[summary.mode];
  return tally;
}

Estimate estimate_of(stats::Proportion counts, double confidence, std::size_t categories) {
  return {.counts = counts,
          .estimate = static_cast<double>(counts.successes) / static_cast<double>(counts.trials),
          .wilson = stats::wilson(counts, confidence),
          .clopper_pearson = stats::clopper_pearson(counts, confidence),
          .simultaneous = stats::bonferroni_clopper_pearson(counts, confidence, categories)};
}

bool is_clamped(const Clamps& clamps) {
  return clamps.kinetic_at_zero + clamps.kinetic_at_static + clamps.static_at_zero + clamps.restitution +
             clamps.amplitude_at_zero >
         0;
}

Validity validity_of(std::span<const Summary> realisations) {
  Validity validity;
  for (std::uint64_t number = 0; number < realisations.size(); ++number) {
    const Summary& summary = realisations[number];
    if (summary.left_ground) validity.left_ground.add(number);
    if (summary.termination == dynamics::Termination::painleve) validity.painleve.add(number);
    if (summary.termination == dynamics::Termination::stopped) validity.stopped.add(number);
    if (summary.in_transient) validity.in_transient.add(number);
    if (summary.was_past_balance) validity.past_balance.add(number);
    if (summary.met_contradiction) validity.contradictions.add(number);
    if (summary.clamped) validity.clamped.add(number);
    const bool named = summary.mode.kind != ResponseKind::unresolved;
    const bool ran_through = summary.termination == dynamics::Termination::reached_horizon;
    if (!named && ran_through) validity.unresolved[summary.reason].add(number);
  }
  return validity;
}

/// Collects when pairs of runs parted.
class PartingTally {
 public:
  void add(const std::optional<std::int64_t>& parted) {
    ++pairs_;
    if (parted) times_.push_back(static_cast<double>(*parted));
  }

  [[nodiscard]] PartingTimes times() {
    std::sort(times_.begin(), times_.end());
    const std::size_t later = pairs_ - times_.size();
    return {.pairs = pairs_,
            .parted = times_.size(),
            .lower_quartile = stats::censored_quantile(times_, later, 0.25),
            .median = stats::censored_quantile(times_, later, 0.5),
            .upper_quartile = stats::censored_quantile(times_, later, 0.75)};
  }

 private:
  std::size_t pairs_ = 0;
  std::vector<double> times_;
};

NonRecurrence non_recurrence_of(const Condition& condition, std::span<const Summary> realisations,
                                const Tally& tally) {
  std::vector<std::uint64_t> counts;
  for (const auto& [mode, count] : tally) counts.push_back(count);
  stats::Proportion differing_pairs;
  PartingTally by_friction;
  for (std::size_t i = 0; i + 1 < realisations.size(); i += 2) {
    ++differing_pairs.trials;
    differing_pairs.successes += realisations[i].mode == realisations[i + 1].mode ? 0 : 1;
    by_friction.add(realisations[i].parted_from_next);
  }
  stats::Proportion flips;
  PartingTally by_arithmetic;
  for (const Summary& summary : realisations) {
    if (!summary.repeat) continue;
    ++flips.trials;
    flips.successes += summary.repeat->mode == summary.mode ? 0 : 1;
    by_arithmetic.add(summary.repeat->parted);
  }
  NonRecurrence result{.differ = stats::probability_of_difference(counts),
                       .differ_interval = stats::clopper_pearson(differing_pairs, condition.confidence),
                       .entropy = stats::entropy(counts),
                       .friction = by_friction.times(),
                       .arithmetic = by_arithmetic.times(),
                       .arithmetic_tolerance = repeat_tolerance(condition.tolerance),
                       .arithmetic_flips = flips};
  // The estimate uses all pairs, the interval only disjoint ones, which are independent: where the two disagree the
  // interval gives way, which can only make it cover more often.
  result.differ_interval.low = std::min(result.differ_interval.low, result.differ);
  result.differ_interval.high = std::max(result.differ_interval.high, result.differ);
  return result;
}

}  // namespace

Effort& Effort::operator+=(const Effort& other) {
  steps += other.steps;
  slip_steps += other.slip_steps;
  root_isolations += other.root_isolations;
  record_segments += other.record_segments;
  companion_periods += other.companion_periods;
  static_friction_draws += other.static_friction_draws;
  kinetic_friction_draws += other.kinetic_friction_draws;
  restitution_draws += other.restitution_draws;
  amplitude_draws += other.amplitude_draws;
  initial_draws += other.initial_draws;
  for (std::size_t kind = 0; kind < events.size(); ++kind) events[kind] += other.events[kind];
  return *this;
}

Clamps& Clamps::operator+=(const Clamps& other) {
  kinetic_at_zero += other.kinetic_at_zero;
  kinetic_at_static += other.kinetic_at_static;
  static_at_zero += other.static_at_zero;
  restitution += other.restitution;
  amplitude_at_zero += other.amplitude_at_zero;
  return *this;
}

Summary summarise(const Record& record, std::uint64_t realisation) {
  return {.mode = record.verdict.mode,
          .reason = record.verdict.reason,
          .termination = record.termination,
          .in_transient = record.verdict.in_transient,
          .left_ground = record.losses_of_contact > 0,
          .was_past_balance = record.was_past_balance,
          .met_contradiction = record.contradictions > 0,
          .clamped = is_clamped(record.clamps),
          .digest = digest_of(record, realisation),
          .parted_from_next = std::nullopt,
          .repeat = std::nullopt};
}

double repeat_tolerance(double tolerance) { return std::max(1e-16, tolerance / 100.0); }

ConditionResult reduce(const Condition& condition, std::span<const Summary> realisations, const Totals& totals) {
  const Tally tally = tally_of(realisations);
  ConditionResult result;
  result.realisations = realisations.size();
  for (const auto& [mode, count] : tally) {
    result.modes.push_back(
        {.mode = mode,
         .probability = estimate_of({.successes = count, .trials = realisations.size()}, condition.confidence,
                                    tally.size())});
  }
  if (realisations.size() >= 2) result.non_recurrence = non_recurrence_of(condition, realisations, tally);
  result.validity = validity_of(realisations);
  result.validity.clamps = totals.clamps;
  result.effort = totals.effort;
  result.stopped_because = is_random(condition.scene) ? "all_realisations_done" : "deterministic";
  return result;
}

}  // namespace rocking::experiment
