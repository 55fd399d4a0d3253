#include "rocking/studies/infer/survey.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "rocking/studies/infer/prior.hpp"

namespace rocking::infer {
namespace {

double to_six_digits(double number) {
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::scientific, 5);
  static_cast<void>(error);  // 32 characters hold every double in 6 digits
  double rounded = number;
  std::from_chars(digits, end, rounded);
  return rounded;
}

/// Without a prior it is 0.
double log_prior(const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    if (unknowns[k].prior) sum += log_density(*unknowns[k].prior, values[k]);
  }
  return sum;
}

Survey on_lattice(const std::vector<ShareModel>& models, const Counts& counts, const std::vector<Unknown>& unknowns,
                  Lattice lattice) {
  Survey found{.likelihood = Likelihood(models, std::move(lattice)), .logarithms = {}, .deviances = {}, .weights = {}};
  found.logarithms = found.likelihood.logarithms(counts);
  found.deviances = deviances(found.logarithms);
  const Scale scale(unknowns);
  found.weights = found.logarithms;
  for (Eigen::Index i = 0; i < found.weights.size(); ++i) {
    found.weights[i] +=
        log_prior(unknowns, scale.values(found.likelihood.lattice().point(static_cast<std::size_t>(i))));
  }
  found.weights = (found.weights.array() - found.weights.maxCoeff()).exp().matrix();
  found.weights /= found.weights.sum();
  return found;
}

}  // namespace

std::vector<double> Scale::values(const Eigen::VectorXd& point) const {
  std::vector<double> values;
  for (std::size_t k = 0; k < unknowns_->size(); ++k) values.push_back(value(k, point[static_cast<Eigen::Index>(k)]));
  return values;
}

std::vector<double> Scale::short_values(const Eigen::VectorXd& point) const {
  std::vector<double> values = this->values(point);
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = std::clamp(to_six_digits(values[k]), (*unknowns_)[k].from, (*unknowns_)[k].to);
  }
  return values;
}

Eigen::VectorXd Scale::point(const std::vector<double>& values) const {
  Eigen::VectorXd point(static_cast<Eigen::Index>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Unknown& range = (*unknowns_)[k];
    point[static_cast<Eigen::Index>(k)] = (values[k] - range.from) / (range.to - range.from);
  }
  return point;
}

Survey survey(const std::vector<ShareModel>& models, const Counts& counts, const std::vector<Unknown>& unknowns) {
  const auto axes = static_cast<Eigen::Index>(unknowns.size());
  Survey found = on_lattice(models, counts, unknowns,
                            Lattice({.low = Eigen::VectorXd::Zero(axes), .high = Eigen::VectorXd::Ones(axes)}));
  constexpr int most_windows = 4;
  for (int i = 1; i < most_windows; ++i) {
    constexpr double unlikely = 20.0;  // of a deviance
    const double least_weight = 1e-4 * found.weights.maxCoeff();
    const Window window = window_around(found.likelihood.lattice(), [&](std::size_t point) {
      const auto place = static_cast<Eigen::Index>(point);
      return found.deviances[place] <= unlikely || found.weights[place] >= least_weight;
    });
    const Window& present = found.likelihood.lattice().window();
    const Eigen::VectorXd smaller = (window.high - window.low).cwiseQuotient(present.high - present.low);
    if (smaller.minCoeff() > 0.7) break;
    found = on_lattice(models, counts, unknowns, Lattice(window));
  }
  return found;
}

}  // namespace rocking::infer
