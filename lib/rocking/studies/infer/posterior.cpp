#include "rocking/studies/infer/posterior.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"

namespace rocking::infer {
namespace {

constexpr double impossible = -std::numeric_limits<double>::infinity();

struct LogDensity {
  double value;

  double operator()(double) const { throw std::invalid_argument("a number has no density"); }
  double operator()(const Values&) const { throw std::invalid_argument("single values have no density"); }
  double operator()(const Uniform& law) const { return law.low <= value && value <= law.high ? 0.0 : impossible; }
  double operator()(const Normal& law) const {
    if (law.between && (value < law.between->least || value > law.between->largest)) return impossible;
    return -0.5 * std::pow((value - law.mean) / law.sigma, 2);
  }
  double operator()(const Lognormal& law) const {
    if (value <= 0.0) return impossible;
    const double variance = std::log1p(std::pow(law.sigma / law.mean, 2));
    const double logarithm = std::log(value);
    return -0.5 * std::pow(logarithm - std::log(law.mean) + 0.5 * variance, 2) / variance - logarithm;
  }
  double operator()(const Triangular& law) const {
    if (value < law.low || value > law.high) return impossible;
    if (value < law.mode) return std::log((value - law.low) / (law.mode - law.low));
    return value > law.mode ? std::log((law.high - value) / (law.high - law.mode)) : 0.0;
  }
};

}  // namespace

double log_density(const Quantity& law, double value) {
  return std::visit(LogDensity{value}, static_cast<const NumberOrLaw&>(law));
}

namespace {

bool has_prior(const Unknown& unknown) { return unknown.prior.has_value(); }

double log_prior(const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    if (unknowns[k].prior) sum += log_density(*unknowns[k].prior, values[k]);
  }
  return sum;
}

/// Part of the cell of a point that is within the window.
double part_of_cell(const Lattice& lattice, std::size_t point) {
  double part = 1.0;
  for (std::size_t axis = 0; axis < lattice.axes(); ++axis) {
    const std::size_t place = lattice.place(point, axis);
    if (place == 0 || place + 1 == lattice.points_on_axis()) part *= 0.5;
  }
  return part;
}

Posterior weighted(Lattice lattice, const Eigen::VectorXd& logarithms, const std::vector<Unknown>& unknowns) {
  const Scale scale(unknowns);
  Eigen::VectorXd weights = logarithms;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    weights[i] += log_prior(unknowns, scale.values(lattice.point(static_cast<std::size_t>(i))));
  }
  weights = (weights.array() - weights.maxCoeff()).exp().matrix();
  for (Eigen::Index i = 0; i < weights.size(); ++i) weights[i] *= part_of_cell(lattice, static_cast<std::size_t>(i));
  weights /= weights.sum();
  return {.lattice = std::move(lattice), .weights = std::move(weights)};
}

Posterior on_window(const std::vector<ShareModel>& models, const Counts& counts, const std::vector<Unknown>& unknowns,
                    Window window, const base::ManyParts& how) {
  const Likelihood likelihood(models, Lattice(std::move(window)), how);
  return weighted(likelihood.lattice(), likelihood.logarithms(counts), unknowns);
}

}  // namespace

Window reach_of_priors(const std::vector<Unknown>& unknowns) {
  const auto axes = static_cast<Eigen::Index>(unknowns.size());
  Window window{.low = Eigen::VectorXd::Zero(axes), .high = Eigen::VectorXd::Ones(axes)};
  for (Eigen::Index axis = 0; axis < axes; ++axis) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(axis)];
    if (!unknown.prior) continue;
    const Reach reach = rocking::reach_of(*unknown.prior);
    const double width = unknown.to - unknown.from;
    window.low[axis] = std::max((reach.least - unknown.from) / width, 0.0);
    window.high[axis] = std::min((reach.largest - unknown.from) / width, 1.0);
    if (window.low[axis] >= window.high[axis]) {
      throw base::InputError({"/unknown/" + std::to_string(axis) + "/prior", "",
                              "has no weight between " + base::shortest(unknown.from) + " and " +
                                  base::shortest(unknown.to) + ", the range of the unknown",
                              "widen the range, or give a law with a density there"});
    }
  }
  return window;
}

Posterior posterior_of(const std::vector<ShareModel>& models, const Counts& counts,
                       const std::vector<Unknown>& unknowns, const Survey& found, const base::ManyParts& how) {
  if (std::ranges::none_of(unknowns, has_prior)) {
    return weighted(found.likelihood.lattice(), found.logarithms, unknowns);
  }
  Posterior posterior = on_window(models, counts, unknowns, reach_of_priors(unknowns), how);
  constexpr int most_windows = 6;
  for (int i = 1; i < most_windows; ++i) {
    const double least = 1e-6 * posterior.weights.maxCoeff();
    const Window window = window_around(posterior.lattice, [&](std::size_t point) {
      return posterior.weights[static_cast<Eigen::Index>(point)] >= least;
    });
    if (!is_much_smaller(window, posterior.lattice.window())) break;
    posterior = on_window(models, counts, unknowns, window, how);
  }
  return posterior;
}

UnknownPosterior summary(const Posterior& posterior, const std::vector<Unknown>& unknowns, std::size_t unknown,
                         double confidence) {
  const Lattice& lattice = posterior.lattice;
  const Scale scale(unknowns);
  std::vector<double> weights(lattice.points_on_axis());
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    weights[lattice.place(i, unknown)] += posterior.weights[static_cast<Eigen::Index>(i)];
  }
  const double low = lattice.coordinate(0, unknown);
  const double high = lattice.coordinate(weights.size() - 1, unknown);
  const double half = 0.5 * (lattice.coordinate(1, unknown) - low);
  UnknownPosterior summary;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    summary.mean += weights[i] * scale.value(unknown, lattice.coordinate(i, unknown));
  }
  // Each weight is spread evenly over the cell of its place.
  const auto quantile = [&](double level) {
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] > 0.0 && sum + weights[i] >= level) {
        const double from = std::max(lattice.coordinate(i, unknown) - half, low);
        const double to = std::min(lattice.coordinate(i, unknown) + half, high);
        return scale.value(unknown, std::lerp(from, to, (level - sum) / weights[i]));
      }
      sum += weights[i];
    }
    return scale.value(unknown, high);
  };
  const double tail = 0.5 * (1.0 - confidence);
  summary.median = quantile(0.5);
  summary.interval = {.low = quantile(tail), .high = quantile(1.0 - tail)};
  return summary;
}

}  // namespace rocking::infer
