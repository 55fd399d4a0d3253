#include "rocking/section/classify.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/section/closed_curves.hpp"
#include "rocking/section/noisy_response.hpp"
#include "rocking/section/recurrence.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t fewest_noise_free = 2 * static_cast<std::size_t>(longest_period);
constexpr std::size_t fewest_random = 4 * static_cast<std::size_t>(longest_period);

enum class Sign : std::uint8_t { negative, unclear, positive };

struct ExponentFinding {
  Sign sign = Sign::unclear;
  double margin = 0.0;
};

/// The exponent differs clearly from zero if it exceeds a number of standard errors and if it changes a distance by
/// more than a factor over the window. A smaller change could not be seen in the window itself.
double clear_distance(const ExponentEstimate& estimate, double standard_errors, double periods,
                      const Thresholds& thresholds) {
  return std::max(standard_errors * estimate.standard_error, thresholds.clear_growth / periods);
}

ExponentFinding judge(const std::optional<ExponentEstimate>& estimate, double periods, const Thresholds& thresholds) {
  if (!estimate) return {};
  const double needed = clear_distance(*estimate, thresholds.clear_standard_errors, periods, thresholds);
  const double margin = std::min(std::max(estimate->exponent, -estimate->exponent) / needed, largest_margin);
  if (estimate->exponent > needed) return {Sign::positive, margin};
  if (estimate->exponent < -needed) return {Sign::negative, margin};
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
/// curves and the exponent may be zero.
template <class Decide>
PendingClassification by_exponent(const ClassifierInput& input, DecisiveSigns decisive, Decide decide) {
  const auto window = static_cast<double>(input.periods.size());
  const Thresholds& thresholds = input.thresholds;
  const double resolution = input.resolution;
  const auto may_be_closed = [](const LongSection& all) {
    return all.exponent && may_be_zero(*all.exponent, all.points.size());
  };
  const auto with_exponent = [=](const std::optional<ExponentEstimate>& estimate,
                                 const LongSection& all) -> Classification {
    const Classification decided = decide(judge(estimate, window, thresholds));
    const bool is_open =
        decided.mode.kind == ResponseKind::unresolved && judge(all.exponent, window, thresholds).sign == Sign::unclear;
    if (!is_open || !may_be_closed(all)) return decided;
    const auto curves = find_closed_curves(all.points, resolution, thresholds);
    return curves ? quasi_periodic(*curves) : decided;
  };
  const auto later = [=](const ExponentEstimate& estimate) {
    return may_be_decided_later(estimate, decisive, window, thresholds);
  };
  const auto more_points = [=](const LongSection& all) {
    return may_be_closed(all) && may_be_closed_curves(all.points, resolution, thresholds);
  };
  return {.classification = std::nullopt,
          .with_exponent = with_exponent,
          .may_be_decided_later = later,
          .may_be_quasi_periodic = more_points};
}

PendingClassification classified(const Classification& classification) {
  PendingClassification found;
  found.classification = classification;
  return found;
}

Classification chaotic(const ExponentFinding& exponent) {
  return {{ResponseKind::chaotic, 0, 0}, Reason::positive_exponent, false, exponent.margin};
}

PendingClassification classify_noise_free(const ClassifierInput& input) {
  if (input.periods.size() < fewest_noise_free) return classified(unresolved(Reason::too_few_points));
  if (const auto classification = find_recurrence(input.periods, input.resolution, input.thresholds))
    return classified(*classification);
  return by_exponent(input, {.negative = false, .positive = true}, [](const ExponentFinding& judged) {
    switch (judged.sign) {
      case Sign::positive: return chaotic(judged);
      case Sign::negative: return unresolved(Reason::not_periodic);
      case Sign::unclear: break;
    }
    return unresolved(Reason::exponent_unclear);
  });
}

/// Classifies a response that is not described by n clouds over the whole window.
PendingClassification classify_unsteady(const ClassifierInput& input, const Finding& finding) {
  // If the clouds persist and only the impacts are irregular, no part shows more than the whole window.
  const bool clouds_stay = finding.classification.reason == Reason::impacts_irregular;
  const RegimeChange change =
      clouds_stay ? RegimeChange{} : find_regimes(input.periods, input.resolution, input.thresholds);
  Classification fallback = finding.classification;
  if (change.reason) fallback = unresolved(*change.reason, *change.reason == Reason::changed_regime);
  if (!change.last_regime && finding.need == ExponentNeed::none) return classified(fallback);
  const DecisiveSigns decisive{.negative = change.last_regime.has_value(),
                               .positive = finding.need == ExponentNeed::to_find_chaos};
  return by_exponent(input, decisive, [fallback, decisive, last = change.last_regime](const ExponentFinding& judged) {
    if (judged.sign == Sign::positive && decisive.positive) return chaotic(judged);
    if (judged.sign != Sign::negative || !last) return fallback;
    Classification settled = *last;
    settled.margin = std::min(settled.margin, judged.margin);
    return settled;
  });
}

PendingClassification classify_random(const ClassifierInput& input) {
  if (input.periods.size() < fewest_random) return classified(unresolved(Reason::too_few_points));
  const Finding finding = find_clouds(input.periods, input.resolution, input.thresholds);
  if (finding.classification.mode.kind == ResponseKind::unresolved) return classify_unsteady(input, finding);
  if (finding.need == ExponentNeed::none) return classified(finding.classification);
  const auto decide = [classification = finding.classification](const ExponentFinding& judged) {
    if (judged.sign == Sign::positive) return chaotic(judged);
    if (judged.sign == Sign::unclear) return unresolved(Reason::exponent_unclear, classification.in_transient);
    Classification settled = classification;
    settled.margin = std::min(settled.margin, judged.margin);
    return settled;
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
