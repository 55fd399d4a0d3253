#include "rocking/stats/fit_suite.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/stats/centred_suite.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

constexpr double largest_suite_dispersion = 10.0;
/// A between-record dispersion below this share of the other, found by a step fit with one range of capacities, is that
/// of a likelihood without a maximum.
constexpr double steepest_line = 1e6;

bool has_two_intensities(const std::vector<ProbitCounts>& pooled) { return pooled.size() > 1; }

std::size_t distinct_records(const std::vector<RecordCounts>& records) {
  return static_cast<std::size_t>(
      std::count_if(records.begin(), records.end(), [](const RecordCounts& record) { return record.weight > 0.0; }));
}

SuiteFit without_law(FragilityOutcome outcome) { return {.outcome = outcome, .law = std::nullopt}; }

SmoothFunction capacity_likelihood(const std::vector<CapacityRange>& ranges) {
  return [&ranges](const Eigen::VectorXd& line) { return capacity_log_likelihood(ranges, Eigen::Vector2d(line)); };
}

/// A line to start from: capacities in the middle of their ranges.
Eigen::Vector2d first_line(const std::vector<CapacityRange>& ranges) {
  double sum = 0.0, squares = 0.0, weight = 0.0;
  for (const CapacityRange& range : ranges) {
    const double middle = std::isinf(range.low)    ? range.high
                          : std::isinf(range.high) ? range.low
                                                   : 0.5 * (range.low + range.high);
    sum += range.weight * middle;
    squares += range.weight * middle * middle;
    weight += range.weight;
  }
  const double mean = sum / weight;
  const double spread = std::sqrt(std::max(1e-4, squares / weight - mean * mean));
  return {-mean / spread, 1.0 / spread};
}

SuiteFit fit_steps(const std::vector<CapacityRange>& ranges, double centre) {
  if (have_a_common_capacity(ranges)) return without_law(FragilityOutcome::separated);
  const Ascent found = climb(capacity_likelihood(ranges), first_line(ranges));
  const double a = found.at[0];
  const double b = found.at[1];
  if (!found.has_converged || !(b > 1.0 / largest_suite_dispersion)) {
    return without_law(FragilityOutcome::does_not_rise);
  }
  if (b > steepest_line) return without_law(FragilityOutcome::separated);
  return {.outcome = FragilityOutcome::fitted,
          .law = SuiteLaw{.median = std::exp(centre - a / b),
                          .between_records = 1.0 / b,
                          .within_record = 0.0,
                          .log_likelihood = found.shape.value}};
}

SuiteFit fit_mixed(const std::vector<RecordCounts>& records, double centre, const MixedProbitStart* start) {
  Ascent found;
  if (start != nullptr) found = most_likely_mixed_probit(records, *start);
  if (!found.has_converged) found = most_likely_mixed_probit(records);
  const double b = found.at[1];
  const double t = found.at[2];
  const bool rises = b > 0.0 && std::sqrt(1.0 + t * t) / b < largest_suite_dispersion;
  if (!found.has_converged || !rises) return without_law(FragilityOutcome::does_not_rise);
  return {.outcome = FragilityOutcome::fitted,
          .law = SuiteLaw{.median = std::exp(centre - found.at[0] / b),
                          .between_records = t / b,
                          .within_record = 1.0 / b,
                          .log_likelihood = found.shape.value}};
}

}  // namespace

CentredSuite centred(const SuiteLevels& suite) {
  CentredSuite found;
  double levels = 0.0;
  for (const auto& record : suite) {
    for (const RecordLevel& level : record) {
      ROCKING_EXPECT(level.intensity > 0.0 && level.happened.trials > 0);
      found.centre += std::log(level.intensity);
      found.is_unresolved = found.is_unresolved || level.unresolved > 0;
      levels += 1.0;
    }
  }
  found.centre /= std::max(1.0, levels);
  for (const auto& record : suite) {
    RecordCounts counts;
    for (const RecordLevel& level : record) {
      counts.counts.push_back({.u = std::log(level.intensity) - found.centre,
                               .happened = static_cast<double>(level.happened.successes),
                               .did_not = static_cast<double>(level.happened.trials - level.happened.successes)});
    }
    found.records.push_back(std::move(counts));
  }
  return found;
}

SuiteFit fit_centred(const CentredSuite& suite, const MixedProbitStart* start) {
  if (suite.is_unresolved) return without_law(FragilityOutcome::unresolved);
  const std::vector<ProbitCounts> pooled = pooled_counts(suite.records);
  if (distinct_records(suite.records) < 2 || !has_two_intensities(pooled)) {
    return without_law(FragilityOutcome::too_little);
  }
  switch (shape_of(pooled)) {
    case ProbitShape::never_happened: return without_law(FragilityOutcome::never_happened);
    case ProbitShape::always_happened: return without_law(FragilityOutcome::always_happened);
    case ProbitShape::rising_step: return without_law(FragilityOutcome::separated);
    case ProbitShape::falling_step: return without_law(FragilityOutcome::does_not_rise);
    case ProbitShape::has_maximum: break;
  }
  if (const auto ranges = capacity_ranges(suite.records)) return fit_steps(*ranges, suite.centre);
  return fit_mixed(suite.records, suite.centre, start);
}

std::optional<MixedProbitStart> start_at(const CentredSuite& suite, const SuiteLaw& law) {
  if (!(law.within_record > 0.0)) return std::nullopt;
  const double b = 1.0 / law.within_record;
  return mixed_probit_start(suite.records,
                            {b * (suite.centre - std::log(law.median)), b, std::max(0.1, law.between_records * b)});
}

double SuiteLaw::dispersion() const { return std::hypot(between_records, within_record); }

double SuiteLaw::probability(double intensity) const { return normal_cdf(std::log(intensity / median) / dispersion()); }

SuiteFit fit_suite(const SuiteLevels& suite) { return fit_centred(centred(suite)); }

SuiteFit fit_suite_near(const SuiteLevels& suite, const SuiteLaw& near) {
  const CentredSuite data = centred(suite);
  const std::optional<MixedProbitStart> start = start_at(data, near);
  return fit_centred(data, start ? &*start : nullptr);
}

}  // namespace rocking::stats
