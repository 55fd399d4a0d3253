#include "rocking/stats/fit_suite.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/mixed_probit.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/unseen_record.hpp"

namespace rocking::stats {
namespace {

constexpr double largest_suite_dispersion = 10.0;
/// A between-record dispersion below this share of the other, found by a step fit with one range of capacities, is that
/// of a likelihood without a maximum.
constexpr double steepest_line = 1e6;

/// The counts of a suite with u = ln intensity - centre.
struct CentredSuite {
  double centre = 0.0;
  std::vector<RecordCounts> records;
  bool is_unresolved = false;  ///< the outcome of some trial is not known
};

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

/// `start`: of the search where not every record is a step; null: several.
SuiteFit fit_centred(const CentredSuite& suite, const MixedProbitStart* start = nullptr) {
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

/// At the law of the whole suite, from which a search over a bootstrap sample starts. Absent where its records are steps.
std::optional<MixedProbitStart> start_at(const CentredSuite& suite, const SuiteLaw& law) {
  if (!(law.within_record > 0.0)) return std::nullopt;
  const double b = 1.0 / law.within_record;
  return mixed_probit_start(suite.records,
                            {b * (suite.centre - std::log(law.median)), b, std::max(0.1, law.between_records * b)});
}

std::optional<PooledLaw> pooled_law(const CentredSuite& suite) {
  if (suite.is_unresolved) return std::nullopt;
  const std::vector<ProbitCounts> counts = pooled_counts(suite.records);
  if (counts.size() < 2 || shape_of(counts) != ProbitShape::has_maximum) return std::nullopt;
  const ProbitLine line = most_likely_line(counts);
  if (!(line.b > 1.0 / largest_suite_dispersion)) return std::nullopt;
  return PooledLaw{.median = std::exp(suite.centre - line.a / line.b),
                   .dispersion = 1.0 / line.b,
                   .log_likelihood = probit_likelihood(counts, line.a, line.b).value,
                   .deviance = probit_deviance(counts, line)};
}

/// The parameters (a, b, t) that have one value of a quantity, as a function of two others: with derivatives.
struct Restricted {
  MixedProbitParameters at;
  Eigen::Matrix<double, 3, 2> jacobian;
  double bend = 0.0;  ///< second derivative of b by the second parameter
};

/// `value`: of ln median less the centre, or of a dispersion.
Restricted restricted(SuiteQuantity quantity, double value, const Eigen::Vector2d& q) {
  Restricted found;
  found.jacobian.setZero();
  switch (quantity) {
    case SuiteQuantity::median:
      found.at = {-value * q[0], q[0], q[1]};
      found.jacobian << -value, 0.0, 1.0, 0.0, 0.0, 1.0;
      break;
    case SuiteQuantity::within_record:
      found.at = {q[0], 1.0 / value, q[1]};
      found.jacobian << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
      break;
    case SuiteQuantity::between_records:
      found.at = {q[0], q[1], value * q[1]};
      found.jacobian << 1.0, 0.0, 0.0, 1.0, 0.0, value;
      break;
    case SuiteQuantity::dispersion: {
      const double root = std::sqrt(1.0 + q[1] * q[1]);
      found.at = {q[0], root / value, q[1]};
      found.jacobian << 1.0, 0.0, 0.0, q[1] / (value * root), 0.0, 1.0;
      found.bend = 1.0 / (value * root * root * root);
      break;
    }
  }
  return found;
}

/// The two free parameters of `restricted` at a law.
Eigen::VectorXd free_parameters(SuiteQuantity quantity, const MixedProbitParameters& at) {
  const Eigen::Index first = quantity == SuiteQuantity::median ? 1 : 0;
  const Eigen::Index second = quantity == SuiteQuantity::between_records ? 1 : 2;
  Eigen::VectorXd free(2);
  free << at[first], at[second];
  return free;
}

/// The largest log-likelihood with one quantity fixed. Remembers the last maximum, from which the next search starts.
class Profile {
 public:
  Profile(const CentredSuite& suite, const SuiteLaw& law, SuiteQuantity quantity)
      : suite_(suite), quantity_(quantity), median_(std::log(law.median) - suite.centre), law_(law) {
    if (law.within_record == 0.0) ranges_ = capacity_ranges(suite.records);
    reset();
  }

  void reset() {
    if (uses_steps()) {
      const double b = 1.0 / law_.between_records;
      free_ = Eigen::VectorXd::Constant(1, quantity_ == SuiteQuantity::median ? b : -median_ * b);
      return;
    }
    // From a limit without scatter within a record the search starts with a small one.
    const double within = law_.within_record > 0.0 ? law_.within_record : 0.1 * law_.between_records;
    const MixedProbitParameters at(-median_ / within, 1.0 / within, law_.between_records / within);
    free_ = free_parameters(quantity_, at);
  }

  [[nodiscard]] double at(double value) {
    const Ascent found = climb(uses_steps() ? steps_with(value) : mixed_with(value), free_);
    if (std::isfinite(found.shape.value)) free_ = found.at;
    return found.shape.value;
  }

 private:
  [[nodiscard]] bool uses_steps() const { return ranges_.has_value() && quantity_ != SuiteQuantity::within_record; }

  [[nodiscard]] SmoothFunction mixed_with(double value) const {
    return [this, value](const Eigen::VectorXd& q) {
      const Restricted there = restricted(quantity_, value, Eigen::Vector2d(q));
      const LocalShape full = mixed_probit_log_likelihood(suite_.records, there.at);
      LocalShape shape{.value = full.value,
                       .gradient = there.jacobian.transpose() * full.gradient,
                       .hessian = there.jacobian.transpose() * full.hessian * there.jacobian};
      shape.hessian(1, 1) += full.gradient[1] * there.bend;
      return shape;
    };
  }

  /// Of (a, b): the median fixes a = -value b, the dispersion b = 1/value.
  [[nodiscard]] SmoothFunction steps_with(double value) const {
    return [this, value](const Eigen::VectorXd& q) {
      const bool is_median = quantity_ == SuiteQuantity::median;
      const Eigen::Vector2d along = is_median ? Eigen::Vector2d(-value, 1.0) : Eigen::Vector2d(1.0, 0.0);
      const Eigen::Vector2d line =
          is_median ? Eigen::Vector2d(-value * q[0], q[0]) : Eigen::Vector2d(q[0], 1.0 / value);
      const LocalShape full = capacity_log_likelihood(*ranges_, line);
      return LocalShape{.value = full.value,
                        .gradient = Eigen::VectorXd::Constant(1, along.dot(full.gradient)),
                        .hessian = Eigen::MatrixXd::Constant(1, 1, along.dot(full.hessian * along))};
    };
  }

  const CentredSuite& suite_;
  SuiteQuantity quantity_;
  double median_;
  SuiteLaw law_;
  std::optional<std::vector<CapacityRange>> ranges_;
  Eigen::VectorXd free_;
};

/// Derivatives of the logarithm of a quantity by (a, b, t).
Eigen::Vector3d slope_of(SuiteQuantity quantity, const MixedProbitParameters& at) {
  const double b = at[1];
  const double t = at[2];
  switch (quantity) {
    case SuiteQuantity::median: return {-1.0 / b, at[0] / (b * b), 0.0};
    case SuiteQuantity::within_record: return {0.0, -1.0 / b, 0.0};
    case SuiteQuantity::between_records: return {0.0, -1.0 / b, 1.0 / t};
    case SuiteQuantity::dispersion: break;
  }
  return {0.0, -1.0 / b, t / (1.0 + t * t)};
}

/// The place, from `start` in steps that grow from `step`, where a function first exceeds 0; absent if it does not
/// within `most` steps.
template <class Function>
std::optional<double> first_crossing(Function&& function, double start, double step) {
  constexpr int most = 40;
  double inside = start;
  double value_inside = function(start);
  if (value_inside > 0.0) return start;
  for (int i = 0; i < most; ++i, step *= 1.5) {
    const double outside = inside + step;
    const double value = function(outside);
    if (value > 0.0) {
      std::uintmax_t calls = 60;
      const auto [low, high] = boost::math::tools::toms748_solve(
          function, std::min(inside, outside), std::max(inside, outside), inside < outside ? value_inside : value,
          inside < outside ? value : value_inside, boost::math::tools::eps_tolerance<double>(26), calls);
      return 0.5 * (low + high);
    }
    inside = outside;
    value_inside = value;
  }
  return std::nullopt;
}

}  // namespace

double SuiteLaw::dispersion() const { return std::hypot(between_records, within_record); }

double SuiteLaw::probability(double intensity) const { return normal_cdf(std::log(intensity / median) / dispersion()); }

double value_of(SuiteQuantity quantity, const SuiteLaw& law) {
  switch (quantity) {
    case SuiteQuantity::median: return law.median;
    case SuiteQuantity::dispersion: return law.dispersion();
    case SuiteQuantity::between_records: return law.between_records;
    case SuiteQuantity::within_record: break;
  }
  return law.within_record;
}

SuiteFit fit_suite(const SuiteLevels& suite) { return fit_centred(centred(suite)); }

SuiteFit fit_suite_near(const SuiteLevels& suite, const SuiteLaw& near) {
  const CentredSuite data = centred(suite);
  const std::optional<MixedProbitStart> start = start_at(data, near);
  return fit_centred(data, start ? &*start : nullptr);
}

double excess_of_variance(const SuiteLevels& levels, const SuiteLaw& law, SuiteQuantity quantity) {
  const CentredSuite suite = centred(levels);
  if (!(law.within_record > 0.0) || !(law.between_records > 0.0)) return 1.0;
  const double b = 1.0 / law.within_record;
  const MixedProbitParameters at(b * (suite.centre - std::log(law.median)), b, b * law.between_records);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  for (const RecordCounts& record : suite.records) {
    const LocalShape shape = record_log_likelihood(record.counts, at);
    scatter += shape.gradient * shape.gradient.transpose();
    curvature -= shape.hessian;
  }
  const auto records = static_cast<double>(suite.records.size());
  const Eigen::Vector3d slope = slope_of(quantity, at);
  const Eigen::Vector3d lever = curvature.ldlt().solve(slope);
  const double excess = records / (records - 1.0) * lever.dot(scatter * lever) / slope.dot(lever);
  return std::isfinite(excess) ? std::max(1.0, excess) : 1.0;
}

// Dispersions are searched by their logarithm, the median by ln x. A dispersion between records may be 0.
Interval profile_interval(const SuiteLevels& suite, const SuiteLaw& law, SuiteQuantity quantity, double confidence) {
  const CentredSuite data = centred(suite);
  ROCKING_EXPECT(data.records.size() > 1);
  const double reach = two_sided_t_quantile(confidence, static_cast<double>(data.records.size() - 1));
  const double least = law.log_likelihood - 0.5 * reach * reach * excess_of_variance(suite, law, quantity);
  const bool is_median = quantity == SuiteQuantity::median;
  Profile profile(data, law, quantity);
  const auto below = [&](double place) {
    return least - profile.at(is_median ? place - data.centre : std::exp(place));
  };
  const double found = value_of(quantity, law);
  const double step =
      is_median ? 0.5 * reach * law.dispersion() / std::sqrt(static_cast<double>(data.records.size())) : 0.2;
  Interval interval{.low = 0.0, .high = std::numeric_limits<double>::infinity()};
  // Where a dispersion is 0 there is no lower end, and the upper one is searched from a small value.
  const double start = found > 0.0 ? std::log(found) : std::log(0.01 * law.dispersion());
  if (const auto high = first_crossing(below, start, step)) interval.high = std::exp(*high);
  if (found == 0.0) return interval;
  profile.reset();
  const bool may_be_zero = quantity == SuiteQuantity::between_records && law.within_record > 0.0;
  if (may_be_zero && least - profile.at(0.0) <= 0.0) return interval;
  profile.reset();
  if (const auto low = first_crossing(below, start, -step)) interval.low = std::exp(*low);
  return interval;
}

std::optional<PooledLaw> fit_pooled(const SuiteLevels& suite) { return pooled_law(centred(suite)); }

RecordBootstrap bootstrap_records(const SuiteLevels& suite, std::uint64_t samples, const RecordDraws& draws,
                                  const base::ManyParts& how) {
  const CentredSuite data = centred(suite);
  const SuiteFit whole = fit_centred(data);
  const std::optional<MixedProbitStart> start = whole.law ? start_at(data, *whole.law) : std::nullopt;
  const std::size_t records = data.records.size();
  std::vector<std::optional<SuiteLaw>> laws(samples);
  std::vector<std::optional<PooledLaw>> pooled(samples);
  std::vector<std::vector<double>> weights(samples), with_unseen(samples);
  base::for_each_part(how, samples, [&](std::size_t sample) {
    CentredSuite drawn = data;
    for (RecordCounts& record : drawn.records) record.weight = 0.0;
    for (std::size_t number = 0; number < records; ++number) {
      const double place = draws(sample, number) * static_cast<double>(records);
      drawn.records[std::min(records - 1, static_cast<std::size_t>(place))].weight += 1.0;
    }
    for (const RecordCounts& record : drawn.records) weights[sample].push_back(record.weight);
    with_unseen[sample] = shares_with_unseen(records, sample, draws);
    pooled[sample] = pooled_law(drawn);
    if (whole.law) laws[sample] = fit_centred(drawn, start ? &*start : nullptr).law;
  });
  RecordBootstrap found{.samples = samples,
                        .laws = {},
                        .samples_with_law = {},
                        .pooled = {},
                        .weights = std::move(weights),
                        .with_unseen = std::move(with_unseen)};
  for (std::size_t sample = 0; sample < samples; ++sample) {
    if (pooled[sample]) found.pooled.push_back(*pooled[sample]);
    if (!laws[sample]) continue;
    found.laws.push_back(*laws[sample]);
    found.samples_with_law.push_back(sample);
  }
  return found;
}

namespace {

/// Order statistic number p (n + 1), counted from 1, between neighbours linearly.
double percentile(const std::vector<double>& sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  const double place = std::clamp(share * static_cast<double>(sorted.size() + 1) - 1.0, 0.0, last);
  const auto index = static_cast<std::size_t>(place);
  const std::size_t next = std::min(index + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(index);
  // Beside an infinite value the difference may be none.
  if (part == 0.0 || sorted[next] == sorted[index]) return sorted[index];
  return sorted[index] + part * (sorted[next] - sorted[index]);
}

bool are_enough(const std::vector<double>& values, std::uint64_t samples) {
  return samples > 0 && static_cast<double>(values.size()) >= least_share_with_law * static_cast<double>(samples);
}

}  // namespace

std::optional<Interval> percentile_interval(std::vector<double> values, std::uint64_t samples, double confidence) {
  if (!are_enough(values, samples)) return std::nullopt;
  std::sort(values.begin(), values.end());
  return Interval{.low = percentile(values, 0.5 * (1.0 - confidence)),
                  .high = percentile(values, 0.5 * (1.0 + confidence))};
}

std::optional<Interval> bias_corrected_interval(std::vector<double> values, double estimate, std::uint64_t samples,
                                                double confidence) {
  if (!are_enough(values, samples)) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto [equal, above] = std::equal_range(values.begin(), values.end(), estimate);
  const auto count = static_cast<double>(values.size());
  const double below = (static_cast<double>(equal - values.begin()) + 0.5 * static_cast<double>(above - equal)) / count;
  const boost::math::normal_distribution<double> normal;
  const double bias = quantile(normal, std::clamp(below, 0.5 / count, 1.0 - 0.5 / count));
  // With two records the expanded percentiles are the ends themselves.
  const double tail = 0.5 * (1.0 - confidence);
  const double reach = tail > 0.0 ? quantile(complement(normal, tail)) : std::numeric_limits<double>::infinity();
  return Interval{.low = percentile(values, normal_cdf(2.0 * bias - reach)),
                  .high = percentile(values, normal_cdf(2.0 * bias + reach))};
}

double expanded_confidence(double confidence, std::size_t records) {
  if (records < 2) return confidence;
  const auto count = static_cast<double>(records);
  const double reach = std::sqrt(count / (count - 1.0)) * two_sided_t_quantile(confidence, count - 1.0);
  return 1.0 - 2.0 * normal_cdf(-reach);
}

}  // namespace rocking::stats
