#include "rocking/studies/infer/survey.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

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

Survey on_window(const std::vector<ShareModel>& models, const Counts& counts, Window window,
                 const base::ManyParts& how) {
  Survey found{.likelihood = Likelihood(models, Lattice(std::move(window)), how), .logarithms = {}, .deviances = {}};
  found.logarithms = found.likelihood.logarithms(counts);
  found.deviances = deviances(found.logarithms);
  return found;
}

/// Beyond this deviance a value is unlikely. The realisations have an error, too: it counts as their tests would.
double unlikely(const std::vector<ShareModel>& models, const Counts& counts) {
  const auto groups = static_cast<Eigen::Index>(models.front().groups());
  double largest = 0.0;
  for (std::size_t m = 0; m < models.size(); ++m) {
    const double tests = counts.segment(static_cast<Eigen::Index>(m) * groups, groups).sum();
    largest = std::max(largest, tests / models[m].realisations());
  }
  return 20.0 * (1.0 + largest);
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

bool is_much_smaller(const Window& window, const Window& present) {
  return (window.high - window.low).cwiseQuotient(present.high - present.low).minCoeff() <= 0.7;
}

Survey survey(const std::vector<ShareModel>& models, const Counts& counts, const base::ManyParts& how) {
  const auto axes = static_cast<Eigen::Index>(models.front().unknowns());
  Survey found =
      on_window(models, counts, {.low = Eigen::VectorXd::Zero(axes), .high = Eigen::VectorXd::Ones(axes)}, how);
  const double most = unlikely(models, counts);
  constexpr int most_windows = 4;
  for (int i = 1; i < most_windows; ++i) {
    const Window window = window_around(found.likelihood.lattice(), [&](std::size_t point) {
      return found.deviances[static_cast<Eigen::Index>(point)] <= most;
    });
    if (!is_much_smaller(window, found.likelihood.lattice().window())) break;
    found = on_window(models, counts, window, how);
  }
  return found;
}

}  // namespace rocking::infer
