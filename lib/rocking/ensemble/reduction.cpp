#include "rocking/ensemble/reduction.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/ensemble/work_list.hpp"
#include "rocking/stats/diversity.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/quantile.hpp"

namespace rocking {

Quantiles quantiles_of(std::vector<double> values, std::uint64_t beyond, double confidence) {
  std::ranges::sort(values);
  Quantiles quantiles{.realisations = values.size() + beyond, .beyond = beyond, .levels = {}};
  for (const double level : quantile_levels) {
    quantiles.levels.push_back(stats::quantile_estimate(values, beyond, level, confidence));
  }
  return quantiles;
}

void PeakTally::add(const Summary& summary) {
  if (summary.termination != dynamics::Termination::reached_horizon) {
    ++ended_before_;
    return;
  }
  tilt_.push_back(summary.peaks.tilt);
  tilt_rate_.push_back(summary.peaks.tilt_rate);
  slip_.push_back(summary.peaks.slip);
  slip_m_.push_back(summary.peaks.slip_m);
  final_slip_.push_back(summary.peaks.final_slip);
  final_slip_m_.push_back(summary.peaks.final_slip_m);
}

PeakQuantiles PeakTally::quantiles(const Condition& condition) const {
  const double confidence = condition.confidence;
  PeakQuantiles result{.tilt = quantiles_of(tilt_, ended_before_, confidence),
                       .tilt_rate = quantiles_of(tilt_rate_, ended_before_, confidence),
                       .slip = {},
                       .final_slip = {}};
  if (!condition.scene.friction) return result;
  result.slip = {.over_half_diagonal = quantiles_of(slip_, ended_before_, confidence),
                 .metres = quantiles_of(slip_m_, ended_before_, confidence).levels};
  result.final_slip = {.over_half_diagonal = quantiles_of(final_slip_, 0, confidence),
                       .metres = quantiles_of(final_slip_m_, 0, confidence).levels};
  return result;
}

void ExponentTally::add(const Summary& summary) {
  if (!summary.exponent || !summary.exponent_error) return;
  exponents_.push_back(*summary.exponent);
  errors_.push_back(*summary.exponent_error);
}

std::optional<Exponents> ExponentTally::exponents(double confidence) const {
  if (exponents_.empty()) return std::nullopt;
  const stats::CentralMoments moments = stats::central_moments(exponents_);
  const stats::CentralMoments errors = stats::central_moments(errors_);
  const auto n = static_cast<double>(exponents_.size());
  Exponents found{.mean = moments.mean,
                  .standard_error = {},
                  .error_of_one = std::sqrt(errors.second + errors.mean * errors.mean),
                  .quantiles = quantiles_of(exponents_, 0, confidence)};
  if (exponents_.size() > 1) found.standard_error = std::sqrt(moments.second / (n - 1.0));
  return found;
}

using section::ResponseKind;

void DivergenceTally::add(const std::optional<std::int64_t>& diverged) {
  ++pairs_;
  if (diverged) ++times_[*diverged];
}

DivergenceTimes DivergenceTally::times() const {
  DivergenceTimes result{.pairs = pairs_, .diverged = 0, .lower_quartile = {}, .median = {}, .upper_quartile = {}};
  for (const auto& [time, count] : times_) result.diverged += count;
  const std::uint64_t later = pairs_ - result.diverged;
  result.lower_quartile = stats::censored_quantile(times_, later, 0.25);
  result.median = stats::censored_quantile(times_, later, 0.5);
  result.upper_quartile = stats::censored_quantile(times_, later, 0.75);
  return result;
}

void Reduction::add(const Summary& summary) {
  if (is_complete()) return;
  count(summary);
  if (!is_complete()) return;
  peak_quantiles_ = peaks_.quantiles(*condition_);
  found_exponents_ = exponents_.exponents(condition_->confidence);
  peaks_ = {};  // the rows of the next condition follow
  exponents_ = {};
}

void Reduction::count(const Summary& summary) {
  ++modes_[summary.mode];
  if (summary.mode.kind == ResponseKind::overturned && summary.overturned_side) {
    ++overturned_[static_cast<std::size_t>(*summary.overturned_side)];
  }
  add_to_validity(summary);
  add_to_pairs(summary);
  peaks_.add(summary);
  exponents_.add(summary);
  if (condition_->horizon.until_classified) {
    settling_.add(summary);
    response_times_.add(summary);
  }
  operations_ += summary.operations;
  validity_.clamps += summary.clamps;
  digest_.add(summary.digest);
  ++realisations_;
  if (!target_.is_final && realisations_ == target_.realisations) target_ = next_target(*condition_, target_, modes_);
}

void Reduction::add_to_validity(const Summary& summary) {
  const std::uint64_t number = realisations_;
  if (summary.left_ground) validity_.left_ground.add(number);
  if (summary.left_ground_before_fall) validity_.left_ground_before_fall.add(number);
  if (summary.termination == dynamics::Termination::painleve) validity_.painleve.add(number);
  if (summary.termination == dynamics::Termination::stopped) validity_.stopped.add(number);
  if (summary.in_transient) validity_.in_transient.add(number);
  if (summary.was_past_balance) validity_.past_balance.add(number);
  if (summary.met_contradiction) validity_.contradictions.add(number);
  if (summary.was_clamped()) validity_.clamped.add(number);
  const bool named = summary.mode.kind != ResponseKind::unresolved;
  if (named && summary.held < 1.0) validity_.settled_late.add(number);
  if (named) validity_.least_held = std::min(validity_.least_held, summary.held);
  if (!named && summary.reason) validity_.unresolved[*summary.reason].add(number);
  const auto backing = summary.reason ? section::backing_of(*summary.reason) : std::nullopt;
  if (named && backing) validity_.backed_by[*backing].add(number);
}

void Reduction::add_to_pairs(const Summary& summary) {
  if (realisations_ % 2 == 0) {
    first_of_pair_ = summary;
  } else {
    ++differing_pairs_.trials;
    differing_pairs_.successes += summary.mode == first_of_pair_.mode ? 0 : 1;
    by_friction_.add(first_of_pair_.diverged_from_next);
  }
  if (summary.rerun_mode) {
    ++flips_.trials;
    flips_.successes += *summary.rerun_mode == summary.mode ? 0 : 1;
    by_arithmetic_.add(summary.rerun_diverged);
  }
}

ModeTally Reduction::listed_modes() const {
  ModeTally listed = modes_;
  for (const auto& mode : always_listed()) listed.insert({mode, 0});
  return listed;
}

std::uint64_t Reduction::without_answer() const {
  const auto unresolved = modes_.find({});
  return unresolved == modes_.end() ? 0 : validity_.without_answer(unresolved->second);
}

NonRecurrence Reduction::non_recurrence() const {
  std::vector<std::uint64_t> counts;
  for (const auto& [mode, count] : modes_) counts.push_back(count);
  NonRecurrence result{.differ = stats::probability_of_difference(counts),
                       .differ_interval = stats::clopper_pearson(differing_pairs_, condition_->confidence),
                       .entropy = stats::entropy(counts),
                       .friction = by_friction_.times(),
                       .arithmetic = by_arithmetic_.times(),
                       .arithmetic_tolerance = rerun_tolerance(condition_->tolerance),
                       .arithmetic_flips = flips_,
                       .arithmetic_flips_interval = stats::clopper_pearson(flips_, condition_->confidence)};
  // The estimate uses all pairs; the interval uses disjoint pairs only, which are independent. If the estimate lies
  // outside the interval, the interval is extended, which can only increase its coverage.
  result.differ_interval.low = std::min(result.differ_interval.low, result.differ);
  result.differ_interval.high = std::max(result.differ_interval.high, result.differ);
  return result;
}

void Reduction::add_anytime_intervals(std::vector<ModeEstimate>& modes) const {
  const stats::StoppingRule rule = stopping_rule(*condition_);
  for (auto& [mode, probability] : modes) {
    probability.anytime = stats::covering(
        bounds_of(mode, probability.counts, without_answer()),
        [&, &mode = mode](const stats::Proportion& counts) { return anytime_interval(rule, mode, counts); });
  }
}

std::array<SideEstimate, 2> Reduction::overturned_sides() const {
  auto sides = estimate_sides(listed_modes(), overturned_, condition_->confidence, without_answer());
  if (!condition_->until) return sides;
  const stats::StoppingRule rule = stopping_rule(*condition_);
  for (auto& [probability] : sides) {
    probability.anytime =
        stats::covering(stats::bounds_of(probability.counts, without_answer()), [&](const stats::Proportion& counts) {
          return rule.interval(counts, significance_of_side(condition_->confidence));
        });
  }
  return sides;
}

ConditionResult Reduction::result() const {
  ConditionResult result;
  // A member that is not named here does not compile.
  auto& [realisations, modes, left, right, recurrence, peaks, exponents, settling, validity, operations,
         stopped_because] = result;
  realisations = realisations_;
  modes = estimate_modes(listed_modes(), condition_->confidence, without_answer());
  const std::array<SideEstimate, 2> sides = overturned_sides();
  left = sides[0];
  right = sides[1];
  if (realisations_ >= 2) recurrence = non_recurrence();
  peaks = peak_quantiles_ ? *peak_quantiles_ : peaks_.quantiles(*condition_);
  exponents = peak_quantiles_ ? found_exponents_ : exponents_.exponents(condition_->confidence);
  if (!settling_.is_empty()) {
    const DivergenceTimes times = by_friction_.times();
    const std::uint64_t later = times.pairs - times.diverged;
    settling = settling_.result(*condition_, by_friction_.by_period(), later);
    settling->times = response_times_.result(*condition_, by_friction_.by_period(), later);
  }
  validity = validity_;
  operations = operations_;
  if (condition_->until) add_anytime_intervals(modes);
  stopped_because = target_.cause;
  return result;
}

}  // namespace rocking
