#pragma once

#include <functional>

#include "rocking/stats/interval.hpp"
#include "rocking/studies/infer/likelihood.hpp"

namespace rocking::infer {

/// Data sets made up at a point of the unit cube, one in each column.
using MakeUp = std::function<Eigen::MatrixXd(const Eigen::VectorXd& point)>;

/// Least deviance at each place of an axis: the profile likelihood.
[[nodiscard]] Eigen::VectorXd profile_on(const Lattice& lattice, std::size_t axis, const Eigen::VectorXd& deviances);

/// An interval on an axis, from 0 to 1, of places at which the profile is at most a limit: linear in between. It
/// contains all such places.
[[nodiscard]] stats::Interval interval_below(const Lattice& lattice, std::size_t axis, const Eigen::VectorXd& profile,
                                             const Eigen::VectorXd& limits);

/// Limits of the profile at each place of an axis by parametric bootstrap: the quantile at `confidence` of its value
/// there, over data sets made up at the most likely point with this place, but at least the limit of a parameter on its
/// bound, the chi-square quantile at 2 confidence - 1 with one degree of freedom. They are computed at some places, the
/// others lie on straight lines. Source: Chuang & Lai (2000), Statistica Sinica 10, 1-50 (hybrid resampling).
[[nodiscard]] Eigen::VectorXd profile_limits(const Likelihood& likelihood, std::size_t axis,
                                             const Eigen::VectorXd& deviances, const MakeUp& make_up,
                                             double confidence);

/// The places at which profile_limits makes up data sets.
inline constexpr int places_of_limits = 21;

/// Quantile at `confidence` of the deviance at a point, over data sets made up there, but at least the limit of a
/// parameter on its bound: the limit of the joint region. `logarithms`: of the likelihood of each set, in a column.
[[nodiscard]] double region_limit(const Eigen::MatrixXd& logarithms, std::size_t point, double confidence);

}  // namespace rocking::infer
