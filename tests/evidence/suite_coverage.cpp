// How often the intervals of a suite cover the truth, on the program itself: the table "Suites of the program" of
// reports/evidence/intervals.md. Each suite is run and analysed as `rocking run` and `rocking fragility --hazard` do.
//
//     suite_coverage [simulated suites] [threads] [number of the first scenario] [how many]

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/base/many_parts.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "support/constant_suite.hpp"

namespace {

using rocking::stats::Interval;
using rocking::support::ConstantSuite;

rocking::HazardCurve hazard() {
  return {.name = "", .intensity = "scale", .header_line = 1, .points = {{0.05, 6.74e-2}, {2.0, 6.66e-6}}};
}

/// The integral of P |dH| over the one piece of the hazard, in closed form.
double true_rate(const ConstantSuite& suite) {
  const rocking::LognormalCapacity capacity{.centre = std::log(suite.median),
                                            .dispersion = std::hypot(suite.between_records, suite.within_record)};
  return rate_of(capacity, rocking::pieces_between(hazard(), 0.05));
}

enum Quantity : std::size_t { median, dispersion, between, within, rate_by_law, isotonic, reported, quantities };

struct Found {
  bool is_fitted = false, is_rejected = false;
  std::array<bool, quantities> profile{}, bootstrap{};  ///< of rates the one interval
  std::array<double, quantities> values{};
};

struct Counted {
  std::array<double, quantities> profile{}, bootstrap{}, mean{};
};

Found measured(const ConstantSuite& suite, std::size_t number) {
  rocking::support::SplitMix random(2026 + 7919 * number);
  const rocking::Experiment experiment = suite.drawn(random);
  const rocking::RunResult run = rocking::run(experiment);
  const rocking::RunFragility found = rocking::fragility(experiment, run, {.hazard = hazard()});
  const rocking::SuiteCurve& curve = found.suites.front().curve;
  Found result;
  const auto holds = [](const std::optional<Interval>& interval, double truth) {
    return interval && interval->low <= truth && truth <= interval->high;
  };
  result.is_rejected = curve.outcome == rocking::stats::FragilityOutcome::rejected;
  result.is_fitted = curve.pooled.has_value();
  if (curve.pooled) {
    const auto keep = [&](Quantity quantity, const rocking::SuiteEstimate& estimate, double truth) {
      result.profile[quantity] = holds(estimate.interval, truth);
      result.bootstrap[quantity] = holds(estimate.bootstrap, truth);
      result.values[quantity] = estimate.value / truth;
    };
    keep(median, curve.pooled->median, suite.median);
    keep(dispersion, curve.pooled->dispersion, std::hypot(suite.between_records, suite.within_record));
    keep(between, curve.pooled->between_records, suite.between_records);
    keep(within, curve.pooled->within_record, suite.within_record);
  }
  const double truth = true_rate(suite);
  const rocking::SuiteRate& rate = *found.suites.front().rate;
  for (const rocking::RateEstimate& estimate : rate.estimates) {
    const auto keep = [&](Quantity quantity) {
      result.profile[quantity] = holds(estimate.interval, truth);
      result.values[quantity] = estimate.value / truth;
    };
    if (estimate.source == rocking::RateSource::law) keep(rate_by_law);
    if (estimate.source == rocking::RateSource::isotonic) keep(isotonic);
  }
  result.profile[reported] = holds(rate.chosen.interval, truth);
  result.values[reported] = rate.chosen.value / truth;
  return result;
}

void measure(const ConstantSuite& suite, std::size_t suites, unsigned threads) {
  std::vector<Found> found(suites);
  rocking::base::for_each_part({.threads = threads}, suites, [&](std::size_t i) { found[i] = measured(suite, i); });
  double fitted = 0.0, rejected = 0.0;
  Counted all;
  for (const Found& each : found) {
    fitted += each.is_fitted ? 1.0 : 0.0;
    rejected += each.is_rejected ? 1.0 : 0.0;
    for (std::size_t k = 0; k < quantities; ++k) {
      all.profile[k] += each.profile[k] ? 1.0 : 0.0;
      all.bootstrap[k] += each.bootstrap[k] ? 1.0 : 0.0;
      all.mean[k] += each.values[k];
    }
  }
  std::printf("| %s%zu | %.2f | %.2f | %.2f | %zu | %.0f | %.1f |", suite.has_common_numbers ? "common: " : "",
              suite.records, suite.median, suite.between_records, suite.within_record, suite.realisations, fitted,
              100.0 * rejected / fitted);
  for (std::size_t k = median; k <= within; ++k) {
    std::printf(" %.1f, %.1f |", 100.0 * all.profile[k] / fitted, 100.0 * all.bootstrap[k] / fitted);
  }
  for (std::size_t k = rate_by_law; k < quantities; ++k) {
    const double of = k == rate_by_law ? fitted : static_cast<double>(suites);
    std::printf(" %.1f (%.2f) |", 100.0 * all.profile[k] / of, all.mean[k] / of);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int arguments, char** values) {
  const auto number = [&](int place, std::size_t standard) {
    return arguments > place ? static_cast<std::size_t>(std::atoi(values[place])) : standard;
  };
  const std::vector<ConstantSuite> scenarios{
      {},
      {.between_records = 0.15},
      {.realisations = 200, .between_records = 0.15},
      {.realisations = 200},
      {.within_record = 0.1},
      {.records = 10},
      {.records = 10, .between_records = 0.15},
      {.records = 40},
      {.has_common_numbers = true},
      {.between_records = 0.15, .has_common_numbers = true},
      {.realisations = 200, .between_records = 0.15, .has_common_numbers = true}};
  const std::size_t first = number(3, 0);
  for (std::size_t i = first; i < std::min(scenarios.size(), first + number(4, scenarios.size())); ++i) {
    measure(scenarios[i], number(1, 400), static_cast<unsigned>(number(2, 1)));
  }
}
