#include "rocking/stats/binomial_process.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace rocking::stats {
namespace {

/// Of the constant: at 1 in 10^6 the log-odds are -14.
constexpr double constant_variance = 100.0;

double matern(double distance) {
  const double r = std::sqrt(5.0) * distance;
  return (1.0 + r + r * r / 3.0) * std::exp(-r);
}

/// A column for each row of `points`, counted in lengths.
Eigen::MatrixXd scaled(const ProcessScales& scales, const Eigen::MatrixXd& points) {
  return scales.lengths.cwiseInverse().asDiagonal() * points.transpose();
}

/// Between two different points, whose coordinates are counted in lengths.
template <class Column>
double covariance(const ProcessScales& scales, const Column& a, const Column& b) {
  double squares = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return constant_variance + scales.amplitude * scales.amplitude * matern(std::sqrt(squares));
}

double variance(const ProcessScales& scales) {
  return constant_variance + scales.amplitude * scales.amplitude + scales.roughness * scales.roughness;
}

Eigen::MatrixXd covariances(const ProcessScales& scales, const Eigen::MatrixXd& points) {
  const Eigen::MatrixXd columns = scaled(scales, points);
  const Eigen::Index n = points.rows();
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    k(i, i) = variance(scales);
    for (Eigen::Index j = 0; j < i; ++j) k(i, j) = k(j, i) = covariance(scales, columns.col(i), columns.col(j));
  }
  return k;
}

double share_at(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

/// ln(1 + e^x) without overflow.
double soft_plus(double x) { return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x))); }

/// The mode of the log-odds given the counts, and what Laplace's approximation needs of it.
struct Mode {
  Eigen::VectorXd log_odds;
  Eigen::VectorXd weights;
  Eigen::VectorXd root;
  Eigen::MatrixXd factor;
  double log_evidence = 0.0;
};

class Laplace {
 public:
  Laplace(Eigen::MatrixXd covariances, const std::vector<Proportion>& counts)
      : k_(std::move(covariances)), counts_(&counts) {}

  /// Newton's method with halved steps (Rasmussen & Williams, algorithm 3.1).
  [[nodiscard]] Mode mode() const {
    const Eigen::Index n = k_.rows();
    Mode mode{.log_odds = Eigen::VectorXd::Zero(n), .weights = Eigen::VectorXd::Zero(n), .root = {}, .factor = {}};
    double value = objective(mode);
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
      curve(mode);
      const Eigen::VectorXd b = mode.root.cwiseAbs2().cwiseProduct(mode.log_odds) + slope(mode.log_odds);
      const Eigen::VectorXd target = b - solved(mode, k_ * b);
      const double before = value;
      value = advance(mode, target, before);
      if (value - before < 1e-9 * (1.0 + std::abs(value))) break;
    }
    curve(mode);
    mode.log_evidence = value - mode.factor.diagonal().array().log().sum();
    return mode;
  }

 private:
  /// Moves the weights towards `target` until the objective has not fallen; returns it.
  double advance(Mode& mode, const Eigen::VectorXd& target, double before) const {
    const Eigen::VectorXd from = mode.weights;
    constexpr int most_halvings = 30;
    double part = 1.0;
    for (int i = 0; i < most_halvings; ++i, part *= 0.5) {
      mode.weights = from + part * (target - from);
      mode.log_odds = k_ * mode.weights;
      if (const double value = objective(mode); value >= before) return value;
    }
    mode.weights = from;
    mode.log_odds = k_ * from;
    return before;
  }

  [[nodiscard]] double objective(const Mode& mode) const {
    double sum = -0.5 * mode.weights.dot(mode.log_odds);
    for (Eigen::Index i = 0; i < k_.rows(); ++i) {
      const Proportion& count = (*counts_)[static_cast<std::size_t>(i)];
      sum += static_cast<double>(count.successes) * mode.log_odds[i] -
             static_cast<double>(count.trials) * soft_plus(mode.log_odds[i]);
    }
    return sum;
  }

  [[nodiscard]] Eigen::VectorXd slope(const Eigen::VectorXd& log_odds) const {
    Eigen::VectorXd slope(log_odds.size());
    for (Eigen::Index i = 0; i < slope.size(); ++i) {
      const Proportion& count = (*counts_)[static_cast<std::size_t>(i)];
      slope[i] = static_cast<double>(count.successes) - static_cast<double>(count.trials) * share_at(log_odds[i]);
    }
    return slope;
  }

  void curve(Mode& mode) const {
    const Eigen::Index n = k_.rows();
    mode.root.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double share = share_at(mode.log_odds[i]);
      mode.root[i] =
          std::sqrt(static_cast<double>((*counts_)[static_cast<std::size_t>(i)].trials) * share * (1.0 - share));
    }
    Eigen::MatrixXd b = mode.root.asDiagonal() * k_ * mode.root.asDiagonal();
    b.diagonal().array() += 1.0;
    mode.factor = b.llt().matrixL();
  }

  /// root (1 + root K root)^-1 root x.
  [[nodiscard]] static Eigen::VectorXd solved(const Mode& mode, const Eigen::VectorXd& x) {
    Eigen::VectorXd y = mode.root.cwiseProduct(x);
    mode.factor.triangularView<Eigen::Lower>().solveInPlace(y);
    mode.factor.triangularView<Eigen::Lower>().adjoint().solveInPlace(y);
    return mode.root.cwiseProduct(y);
  }

  Eigen::MatrixXd k_;
  const std::vector<Proportion>* counts_;
};

/// The logarithms of the scales, for the search.
Eigen::VectorXd logarithms(const ProcessScales& scales) {
  const Eigen::Index d = scales.lengths.size();
  Eigen::VectorXd all(d + 2);
  all << scales.lengths.array().log().matrix(), std::log(scales.amplitude), std::log(scales.roughness);
  return all;
}

ProcessScales scales_of(const Eigen::VectorXd& logarithms) {
  const Eigen::Index d = logarithms.size() - 2;
  return {.lengths = logarithms.head(d).array().exp().matrix(),
          .amplitude = std::exp(logarithms[d]),
          .roughness = std::exp(logarithms[d + 1])};
}

/// Of lognormal laws: a length of about a half, an amplitude of about two, little roughness.
double log_prior(const Eigen::VectorXd& logarithms) {
  const Eigen::Index d = logarithms.size() - 2;
  const double of_lengths = (logarithms.head(d).array() - std::log(0.5)).square().sum();
  const double of_amplitude = std::pow(logarithms[d] - std::log(2.0), 2);
  const double of_roughness = std::pow((logarithms[d + 1] - std::log(0.05)) / 1.5, 2);
  return -0.5 * (of_lengths + of_amplitude + of_roughness);
}

/// Coordinate search with halved steps: the evidence is flat near its maximum, and a precise one is of no use.
Eigen::VectorXd best_logarithms(const Eigen::MatrixXd& points, const std::vector<Proportion>& counts,
                                base::StopRequest stop, Eigen::VectorXd at) {
  const auto value_at = [&](const Eigen::VectorXd& logarithms) {
    stop.check();
    return Laplace(covariances(scales_of(logarithms), points), counts).mode().log_evidence + log_prior(logarithms);
  };
  double best = value_at(at);
  for (double step = 0.8; step > 0.15; step *= 0.5) {
    constexpr int most_rounds = 6;
    bool has_improved = true;
    for (int round = 0; round < most_rounds && has_improved; ++round) {
      has_improved = false;
      for (Eigen::Index i = 0; i < at.size(); ++i) {
        for (const double sign : {1.0, -1.0}) {
          Eigen::VectorXd other = at;
          other[i] += sign * step;
          const double value = value_at(other);
          if (value <= best + 0.01) continue;
          best = value;
          at = other;
          has_improved = true;
          break;
        }
      }
    }
  }
  return at;
}

}  // namespace

BinomialProcess BinomialProcess::fit(const Eigen::MatrixXd& points, const std::vector<Proportion>& counts,
                                     const ProcessScales& start, base::StopRequest stop) {
  ProcessScales first = start;
  if (first.lengths.size() == 0) first.lengths = Eigen::VectorXd::Constant(points.cols(), 0.5);
  BinomialProcess process;
  process.scales_ = scales_of(best_logarithms(points, counts, stop, logarithms(first)));
  process.columns_ = scaled(process.scales_, points);
  Mode mode = Laplace(covariances(process.scales_, points), counts).mode();
  process.weights_ = std::move(mode.weights);
  process.root_ = std::move(mode.root);
  process.factor_ = std::move(mode.factor);
  return process;
}

Eigen::VectorXd BinomialProcess::covariances_with(const Eigen::VectorXd& point) const {
  const Eigen::MatrixXd column = scaled(scales_, point.transpose());
  Eigen::VectorXd between(columns_.cols());
  for (Eigen::Index i = 0; i < between.size(); ++i) between[i] = covariance(scales_, column.col(0), columns_.col(i));
  return between;
}

double BinomialProcess::mean_at(const Eigen::VectorXd& point) const { return weights_.dot(covariances_with(point)); }

LogOdds BinomialProcess::at(const Eigen::VectorXd& point) const {
  const Eigen::VectorXd between = covariances_with(point);
  Eigen::VectorXd reduced = root_.cwiseProduct(between);
  factor_.triangularView<Eigen::Lower>().solveInPlace(reduced);
  const double left = variance(scales_) - reduced.squaredNorm();
  return {.mean = weights_.dot(between), .deviation = std::sqrt(std::max(left, 0.0))};
}

}  // namespace rocking::stats
