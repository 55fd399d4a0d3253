#include "rocking/section/classify.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/section/closed_curves.hpp"
#include "rocking/section/noisy_response.hpp"
#include "rocking/section/recurrence.hpp"

namespace rocking::section {
namespace {

enum class Sign : std::uint8_t { negative, unclear, positive };

struct ExponentFinding {
  Sign sign = Sign::unclear;
  double margin = 0.0;
  double least_decay =
      0.0;  ///< if negative: lower limit of the rate at which deviations shrink, one standard error off
};

/// Factor for the standard errors at the k-th look. Successive looks share most of their periods: of k looks 1 + log2 k differ
/// by half of them. With 9 + 4 ln(1 + log2 k) in place of 9 in the square, the chance of a wrong sign at the j-th of these falls
/// as 1/j^2, and over all looks is below 1.7 times that at the first.
double factor_at_look(int looks) {
  const double differing = 1.0 + base::natural_logarithm(static_cast<double>(looks)) / std::numbers::ln2;
  return std::sqrt(1.0 + 4.0 / 9.0 * base::natural_logarithm(differing));
}

/// The exponent differs clearly from zero if it exceeds a number of standard errors and if it changes a distance by
/// more than a factor over its periods. A smaller change could not be seen in them.
double clear_distance(const ExponentEstimate& estimate, double standard_errors, double periods,
                      const Thresholds& thresholds) {
  return std::max(standard_errors * estimate.standard_error, thresholds.clear_growth / periods);
}

ExponentFinding judge(const std::optional<ExponentEstimate>& estimate, double periods, const Thresholds& thresholds) {
  if (!estimate) return {};
  const double over = estimate->periods > 0 ? static_cast<double>(estimate->periods) : periods;
  const double needed =
      clear_distance(*estimate, thresholds.clear_standard_errors * factor_at_look(estimate->looks), over, thresholds);
  const double margin = std::min(std::max(estimate->exponent, -estimate->exponent) / needed, largest_margin);
  if (estimate->exponent > needed) return {Sign::positive, margin};
  if (estimate->exponent < -needed) {
    return {Sign::negative, margin, -estimate->exponent - estimate->standard_error};
  }
  return {};
}

/// Which signs of the exponent lead to a classification.
struct DecisiveSigns {
  bool negative;
  bool positive;
};

bool may_be_decided_later(const ExponentEstimate& estimate, DecisiveSigns decisive, double periods,
                          const Thresholds& thresholds) {
  const bool decides = estimate.exponent > 0.0 ? decisive.positive : decisive.negative;
  return decides &&
         std::abs(estimate.exponent) <= clear_distance(estimate, thresholds.sure_standard_errors, periods, thresholds);
}

/// On closed curves neighbouring motions part at most in proportion to time, and part of their distance stays.
bool may_be_zero(const ExponentEstimate& estimate, std::size_t periods) {
  const auto all = static_cast<double>(periods);
  return std::abs(estimate.exponent) * all <= 1.0 + base::natural_logarithm(all);
}

Classification quasi_periodic(const ClosedCurves& found) {
  return {{ResponseKind::quasi_periodic, 0, 0}, Reason::closed_curves, false, found.margin};
}

/// decide(judged) returns the classification. What it leaves unresolved is quasi-periodic if the points lie on closed
/// curves and the exponent may be zero. Without noise, growth that is no faster than on closed curves is no chaos, and growth
/// is followed as far as exponents are, since a motion may be chaotic for long before it comes to an orbit.
template <class Decide>
PendingClassification by_exponent(const ClassifierInput& input, DecisiveSigns decisive, Decide decide) {
  const auto window = static_cast<double>(input.periods.size());
  const Thresholds& thresholds = input.thresholds;
  const double resolution = input.resolution;
  const bool is_noise_free = !input.random;
  const OrbitSource find_orbit = input.find_orbit;
  const auto may_be_closed = [](const LongSection& all) {
    return all.exponent && may_be_zero(*all.exponent, all.points.size());
  };
  const auto with_exponent = [=](const std::optional<ExponentEstimate>& estimate,
                                 const LongSection& all) -> Classification {
    ExponentFinding judged = judge(estimate, window, thresholds);
    if (is_noise_free && judged.sign == Sign::positive) {
      if (all.has_ended) return unresolved(Reason::changed_regime, true);
      judged = judge(all.exponent, window, thresholds);
      if (judged.sign == Sign::positive && may_be_closed(all)) judged = {};
    }
    const Classification decided = decide(judged);
    if (decided.mode.kind != ResponseKind::unresolved || !may_be_closed(all)) return decided;
    if (!is_noise_free && judge(all.exponent, window, thresholds).sign != Sign::unclear) return decided;
    if (is_noise_free && come_closer(all.points)) return unresolved(Reason::still_converging, true);
    const auto curves = find_closed_curves(all.points, resolution, thresholds);
    if (!curves) return decided;
    if (is_noise_free && is_near_longer_orbit(all.points.back(), find_orbit, thresholds)) {
      return unresolved(Reason::period_too_long);
    }
    return quasi_periodic(*curves);
  };
  const auto later = [=](const ExponentEstimate& estimate) {
    return may_be_decided_later(estimate, decisive, window, thresholds);
  };
  const auto more_points = [=](const LongSection& all) {
    if (is_noise_free && judge(all.exponent, window, thresholds).sign == Sign::positive) return true;
    return may_be_closed(all) && may_be_closed_curves(all.points, resolution, thresholds);
  };
  return {.classification = std::nullopt,
          .with_exponent = with_exponent,
          .may_be_decided_later = later,
          .wants_more_points = more_points};
}

PendingClassification classified(const Classification& classification) {
  PendingClassification found;
  found.classification = classification;
  return found;
}

Classification chaotic(const ExponentFinding& exponent) {
  return {{ResponseKind::chaotic, 0, 0}, Reason::positive_exponent, false, exponent.margin};
}

/// The orbit that the points tend to, sought over each of these numbers of periods.
std::optional<Classification> first_approached(const ClassifierInput& input, std::span<const int> candidates) {
  for (const int n : candidates) {
    const auto found = approached_orbit(input.periods, n, input.find_orbit, input.resolution, input.thresholds);
    if (found) return found;
  }
  return std::nullopt;
}

std::optional<Classification> approached_over_any_period(const ClassifierInput& input) {
  std::vector<int> near;
  for (int n = 1; n <= longest_period; ++n) {
    if (may_approach_orbit(input.periods, n, input.resolution, input.thresholds)) near.push_back(n);
  }
  return first_approached(input, near);
}

PendingClassification classify_noise_free(const ClassifierInput& input) {
  const Recurrence recurrence = find_recurrence(input.periods, input.resolution, input.thresholds, input.unfinished);
  if (recurrence.classification) return classified(*recurrence.classification);
  if (const auto found = first_approached(input, recurrence.candidates)) return classified(*found);
  if (!recurrence.candidates.empty()) {
    return classified(approached_over_any_period(input).value_or(unresolved(Reason::still_converging, true)));
  }
  return by_exponent(input, {.negative = false, .positive = true}, [input](const ExponentFinding& judged) {
    if (judged.sign == Sign::positive) return chaotic(judged);
    if (const auto found = approached_over_any_period(input)) return *found;
    return unresolved(judged.sign == Sign::negative ? Reason::not_periodic : Reason::exponent_unclear);
  });
}

/// `settled`, held by the margin of the exponent too.
Classification confirmed(Classification settled, const ExponentFinding& negative) {
  settled.margin = std::min(settled.margin, negative.margin);
  return settled;
}

/// The response of clouds whose exponent is negative and that are not clear by themselves.
std::optional<Classification> about_orbit(const ClassifierInput& input, const Finding& finding) {
  if (finding.periods == 0) return std::nullopt;
  const auto found =
      clouds_about_orbit(input.periods, finding.periods, input.find_orbit, input.resolution, input.thresholds);
  // Clouds that overlap are not told apart by an orbit: only a divisor of their number is.
  const bool overlap = finding.classification.reason == Reason::clouds_overlap;
  if (!found || (overlap && found->mode.periods == finding.periods)) return std::nullopt;
  return found;
}

/// Classifies a response that is not described by n clouds over the whole window.
PendingClassification classify_unsteady(const ClassifierInput& input, const Finding& finding) {
  // If the clouds persist and only the impacts are irregular, no part shows more than the whole window.
  const bool clouds_stay = finding.classification.reason == Reason::impacts_irregular;
  const RegimeChange change =
      clouds_stay ? RegimeChange{} : find_regimes(input.periods, input.resolution, input.thresholds);
  Classification fallback = finding.classification;
  if (change.reason) fallback = unresolved(*change.reason, *change.reason == Reason::changed_regime);
  const bool may_be_about_orbit =
      finding.need != ExponentNeed::none && !change.reason && !change.last_regime && !clouds_stay;
  const auto about = may_be_about_orbit ? about_orbit(input, finding) : std::nullopt;
  // An orbit alone is no reason to run more periods than those of the window.
  const DecisiveSigns decisive{.negative = change.last_regime.has_value(),
                               .positive = finding.need == ExponentNeed::to_find_chaos};
  const auto settled = change.last_regime ? change.last_regime : about;
  if (!settled && !decisive.positive) return classified(fallback);
  return by_exponent(input, decisive, [fallback, decisive, settled](const ExponentFinding& judged) {
    if (judged.sign == Sign::positive && decisive.positive) return chaotic(judged);
    return judged.sign == Sign::negative && settled ? confirmed(*settled, judged) : fallback;
  });
}

/// Share of the window, up to its end, in which points n apart differ by at most `reach`.
double share_held(std::span<const Period> periods, int n, double reach) {
  const auto step = static_cast<std::size_t>(n);
  std::size_t first = periods.size() - step;
  while (first > 0 && distance(periods[first - 1].point, periods[first - 1 + step].point) <= reach) --first;
  return static_cast<double>(periods.size() - first) / static_cast<double>(periods.size());
}

/// What the points of several clouds say without noise: where none acts on the motion, as on a block that does not slide,
/// slow spirals and doublings look like clouds of a multiple of the period.
std::optional<Classification> of_noise_free_points(const ClassifierInput& input, const Finding& finding) {
  Recurrence recurrence = find_recurrence(input.periods, input.resolution, input.thresholds, input.unfinished);
  const ResponseMode& mode = finding.classification.mode;
  if (mode.kind == ResponseKind::periodic &&
      !may_approach_orbit_of_divisor(input.periods, mode.periods, input.resolution, input.thresholds)) {
    std::erase(recurrence.candidates, mode.periods);  // the clouds say that already
  }
  auto found = recurrence.classification ? recurrence.classification : first_approached(input, recurrence.candidates);
  const bool is_another = found && found->mode.kind == ResponseKind::periodic && found->mode != mode;
  if (!is_another) return std::nullopt;
  found->held = share_held(input.periods, found->mode.periods, input.thresholds.reach);
  return found;
}

PendingClassification classify_random(const ClassifierInput& input) {
  const Finding finding = find_clouds(input.periods, input.resolution, input.thresholds);
  const bool is_unresolved = finding.classification.mode.kind == ResponseKind::unresolved;
  if (finding.periods != 1 || is_unresolved) {
    if (const auto found = of_noise_free_points(input, finding)) return classified(*found);
  }
  if (is_unresolved) return classify_unsteady(input, finding);
  if (finding.need == ExponentNeed::none) return classified(finding.classification);
  const auto decide = [input, finding](const ExponentFinding& judged) {
    const Classification& classification = finding.classification;
    if (judged.sign == Sign::positive) return chaotic(judged);
    if (judged.sign == Sign::unclear) return unresolved(Reason::exponent_unclear, classification.in_transient);
    if (are_apart(finding, input.periods.size(), judged.least_decay, input.thresholds)) {
      return confirmed(classification, judged);
    }
    const auto found = about_orbit(input, finding);
    return found ? confirmed(*found, judged) : unresolved(Reason::slow_memory, true);
  };
  return by_exponent(input, {.negative = true, .positive = true}, decide);
}

}  // namespace

std::optional<Reason> reason_named(std::string_view name) {
  const auto found = std::ranges::find(reason_names, name);
  if (found == reason_names.end()) return std::nullopt;
  return static_cast<Reason>(found - reason_names.begin());
}

PendingClassification classify(const ClassifierInput& input) {
  ROCKING_EXPECT(input.resolution > 0.0);
  const bool moved = std::ranges::any_of(input.periods, [](const Period& p) { return p.moved || p.impacts != 0; });
  if (!moved && !input.periods.empty()) {
    return classified({{ResponseKind::rest, 0, 0}, Reason::never_moved, false, largest_margin});
  }
  if (input.periods.size() < static_cast<std::size_t>(fewest_periods(input.random)))
    return classified(unresolved(Reason::too_few_points));
  return input.random ? classify_random(input) : classify_noise_free(input);
}

Classification classify(const ClassifierInput& input, const ExponentSource& exponent) {
  const PendingClassification found = classify(input);
  if (found.classification) return *found.classification;
  std::vector<StrobePoint> points;
  std::ranges::transform(input.periods, std::back_inserter(points), &Period::point);
  const std::optional<ExponentEstimate> estimate = exponent();
  return found.with_exponent(estimate, {.points = points, .exponent = estimate});
}

}  // namespace rocking::section
