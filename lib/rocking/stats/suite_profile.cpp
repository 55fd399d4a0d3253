#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <boost/math/tools/toms748_solve.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/centred_suite.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

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

/// The place, from `start` in steps that grow from `step`, where a function first exceeds 0; absent if it does not within a
/// factor of 1e12. A likelihood that is so flat has no end there that its rounding and a double could tell from none.
template <class Function>
std::optional<double> first_crossing(Function&& function, double start, double step) {
  constexpr double farthest = 27.631021115928547;  // ln 1e12
  // Where the likelihood vanishes, or is not found, the search needs no more than its sign: there is none where it is not known.
  const auto bounded = [&function](double place) {
    const double value = function(place);
    return std::isnan(value) ? -1.0 : std::clamp(value, -1e3, 1e3);
  };
  double inside = start;
  double value_inside = bounded(start);
  if (value_inside > 0.0) return start;
  for (; std::abs(inside - start) < farthest; step *= 1.5) {
    const double outside = std::clamp(inside + step, start - farthest, start + farthest);
    const double value = bounded(outside);
    if (value > 0.0) {
      std::uintmax_t calls = 60;
      const auto [low, high] = boost::math::tools::toms748_solve(
          bounded, std::min(inside, outside), std::max(inside, outside), inside < outside ? value_inside : value,
          inside < outside ? value : value_inside, boost::math::tools::eps_tolerance<double>(26), calls);
      return 0.5 * (low + high);
    }
    inside = outside;
    value_inside = value;
  }
  return std::nullopt;
}

}  // namespace

double value_of(SuiteQuantity quantity, const SuiteLaw& law) {
  switch (quantity) {
    case SuiteQuantity::median: return law.median;
    case SuiteQuantity::dispersion: return law.dispersion();
    case SuiteQuantity::between_records: return law.between_records;
    case SuiteQuantity::within_record: break;
  }
  return law.within_record;
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

}  // namespace rocking::stats
