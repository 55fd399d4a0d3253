#include "rocking/studies/cost/cost.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/stats/quantile.hpp"
#include "rocking/studies/cost/measurement.hpp"

namespace rocking {
namespace {

bool is_flipped(const MeasuredRealisation& realisation, std::size_t tolerance) {
  return realisation.runs[tolerance].mode != realisation.runs.back().mode;
}

void add_errors(Departure& departure, const std::vector<double>& errors) {
  departure.moving = errors.size();
  departure.median_error = stats::lower_median(errors);
  if (!errors.empty()) departure.largest_error = *std::ranges::max_element(errors);
}

void add_flips(Departure& departure, std::span<const MeasuredRealisation> measured, std::size_t tolerance) {
  departure.flips.trials = measured.size();
  for (const MeasuredRealisation& realisation : measured) {
    if (!is_flipped(realisation, tolerance)) continue;
    ++departure.flips.successes;
    if (departure.first_flips.size() == flips_kept) continue;
    departure.first_flips.push_back(
        {.key = realisation.key, .mode = realisation.runs[tolerance].mode, .reference = realisation.runs.back().mode});
  }
}

stats::PairedCounts beside(std::span<const MeasuredRealisation> measured, std::size_t tolerance, std::size_t floor) {
  stats::PairedCounts counts;
  for (const MeasuredRealisation& realisation : measured) {
    const bool here = is_flipped(realisation, tolerance);
    const bool there = is_flipped(realisation, floor);
    ++(here && there ? counts.both : here ? counts.first_only : there ? counts.second_only : counts.neither);
  }
  return counts;
}

Departure departure_of(std::span<const MeasuredRealisation> measured, std::size_t tolerance, double confidence) {
  Departure departure;
  std::vector<double> errors;
  for (const MeasuredRealisation& realisation : measured) {
    const ToleranceRun& run = realisation.runs[tolerance];
    if (run.error) errors.push_back(*run.error);
    if (run.diverged) ++departure.diverged;
  }
  add_errors(departure, errors);
  add_flips(departure, measured, tolerance);
  departure.flips_interval = stats::clopper_pearson(departure.flips, confidence);
  const std::size_t floor = measured.front().runs.size() - 2;
  if (tolerance == floor) return departure;
  departure.beside_tolerance_sensitivity = beside(measured, tolerance, floor);
  departure.beyond_floor = stats::paired_difference_exact(*departure.beside_tolerance_sensitivity, confidence);
  return departure;
}

}  // namespace

double ToleranceCost::steps_per_period() const {
  return periods == 0 ? 0.0 : static_cast<double>(steps) / static_cast<double>(periods);
}

std::vector<ToleranceCost> cost_curve(std::span<const double> tolerances, std::span<const MeasuredRealisation> measured,
                                      double confidence) {
  ROCKING_EXPECT(!measured.empty());
  std::vector<ToleranceCost> curve;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    ToleranceCost cost;
    cost.tolerance = tolerances[i];
    for (const MeasuredRealisation& realisation : measured) {
      cost.periods += realisation.runs[i].periods;
      cost.steps += realisation.runs[i].steps;
    }
    if (i + 1 < tolerances.size()) cost.departure = departure_of(measured, i, confidence);
    curve.push_back(std::move(cost));
  }
  return curve;
}

}  // namespace rocking
