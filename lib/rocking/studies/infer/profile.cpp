#include "rocking/studies/infer/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/chi_squared.hpp>

namespace rocking::infer {
namespace {

/// The smallest value that a share `level` of the numbers and of one more, larger than all, does not exceed.
double upper_quantile(std::vector<double> numbers, double level) {
  std::ranges::sort(numbers);
  const double rank = std::ceil(level * static_cast<double>(numbers.size() + 1));
  return numbers[std::min(static_cast<std::size_t>(rank), numbers.size()) - 1];
}

double limit_on_bound(double confidence) {
  return boost::math::quantile(boost::math::chi_squared(1.0), std::max(2.0 * confidence - 1.0, 0.0));
}

/// The point with the least deviance of those with this place.
std::size_t best_at(const Lattice& lattice, std::size_t axis, std::size_t place, const Eigen::VectorXd& deviances) {
  std::size_t best = lattice.size();
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    if (lattice.place(i, axis) != place) continue;
    if (best == lattice.size() || deviances[static_cast<Eigen::Index>(i)] < deviances[static_cast<Eigen::Index>(best)])
      best = i;
  }
  return best;
}

double limit_at(const Likelihood& likelihood, std::size_t axis, std::size_t place, const Eigen::VectorXd& deviances,
                const MakeUp& make_up, double confidence) {
  const Lattice& lattice = likelihood.lattice();
  const std::size_t best = best_at(lattice, axis, place, deviances);
  const Eigen::MatrixXd sets = make_up(lattice.point(best));
  std::vector<Eigen::Index> at_place;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    if (lattice.place(i, axis) == place) at_place.push_back(static_cast<Eigen::Index>(i));
  }
  std::vector<double> values;
  constexpr Eigen::Index at_once = 32;  // a lattice of three unknowns has 15625 points: all sets would need 50 MB
  for (Eigen::Index first = 0; first < sets.cols(); first += at_once) {
    const Eigen::MatrixXd logarithms =
        likelihood.logarithms_of_sets(sets.middleCols(first, std::min(at_once, sets.cols() - first)));
    for (Eigen::Index set = 0; set < logarithms.cols(); ++set) {
      double inside = -std::numeric_limits<double>::infinity();
      for (const Eigen::Index i : at_place) inside = std::max(inside, logarithms(i, set));
      values.push_back(2.0 * (logarithms.col(set).maxCoeff() - inside));
    }
  }
  return std::max(limit_on_bound(confidence), upper_quantile(std::move(values), confidence));
}

}  // namespace

Eigen::VectorXd profile_on(const Lattice& lattice, std::size_t axis, const Eigen::VectorXd& deviances) {
  Eigen::VectorXd profile = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(lattice.points_on_axis()),
                                                      std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    double& least = profile[static_cast<Eigen::Index>(lattice.place(i, axis))];
    least = std::min(least, deviances[static_cast<Eigen::Index>(i)]);
  }
  return profile;
}

stats::Interval interval_below(const Lattice& lattice, std::size_t axis, const Eigen::VectorXd& profile,
                               const Eigen::VectorXd& limits) {
  const Eigen::VectorXd above = profile - limits;
  const Eigen::Index n = above.size();
  Eigen::Index first = 0;
  while (above[first] > 0.0) ++first;
  Eigen::Index last = n - 1;
  while (above[last] > 0.0) --last;
  const auto coordinate = [&](Eigen::Index place) { return lattice.coordinate(static_cast<std::size_t>(place), axis); };
  /// Between a place inside and its neighbour outside.
  const auto crossing = [&](Eigen::Index inside, Eigen::Index outside) {
    const double part = above[inside] / (above[inside] - above[outside]);
    return coordinate(inside) + part * (coordinate(outside) - coordinate(inside));
  };
  return {.low = first > 0 ? crossing(first, first - 1) : coordinate(first),
          .high = last + 1 < n ? crossing(last, last + 1) : coordinate(last)};
}

Eigen::VectorXd profile_limits(const Likelihood& likelihood, std::size_t axis, const Eigen::VectorXd& deviances,
                               const MakeUp& make_up, double confidence) {
  const auto n = static_cast<Eigen::Index>(likelihood.lattice().points_on_axis());
  constexpr Eigen::Index parts = places_of_limits - 1;
  Eigen::VectorXd limits(n);
  Eigen::Index before = 0;
  for (Eigen::Index part = 0; part <= parts; ++part) {
    const Eigen::Index place = part * (n - 1) / parts;
    limits[place] = limit_at(likelihood, axis, static_cast<std::size_t>(place), deviances, make_up, confidence);
    for (Eigen::Index i = before + 1; i < place; ++i) {
      const double of_way = static_cast<double>(i - before) / static_cast<double>(place - before);
      limits[i] = limits[before] + of_way * (limits[place] - limits[before]);
    }
    before = place;
  }
  return limits;
}

double region_limit(const Eigen::MatrixXd& logarithms, std::size_t point, double confidence) {
  std::vector<double> values;
  for (Eigen::Index set = 0; set < logarithms.cols(); ++set) {
    values.push_back(2.0 * (logarithms.col(set).maxCoeff() - logarithms(static_cast<Eigen::Index>(point), set)));
  }
  return std::max(limit_on_bound(confidence), upper_quantile(std::move(values), confidence));
}

}  // namespace rocking::infer
