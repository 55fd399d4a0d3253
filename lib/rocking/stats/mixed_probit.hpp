#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "rocking/stats/probit.hpp"

/// Probit regression with a random intercept: given z ~ N(0, 1) of its record, a trial at u has the event with
/// probability Phi(a + b u + t z), and trials are independent. Over all records P(event at u) is
/// Phi((a + b u)/sqrt(1 + t^2)).
namespace rocking::stats {

/// A function of a few parameters at one point.
struct LocalShape {
  double value = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

using SmoothFunction = std::function<LocalShape(const Eigen::VectorXd&)>;

struct Ascent {
  Eigen::VectorXd at;
  LocalShape shape;
  bool has_converged = false;
};

/// A local maximum of a smooth function of at most a few parameters, by Newton's method.
///
/// Eigenvalues of the Hessian that are not negative are replaced by minus their absolute values, so that every step
/// ascends; a step is halved until the function increases by a ten-thousandth of what its slope promises (Nocedal &
/// Wright 2006, Numerical Optimization, sections 3.1 and 3.4). Converged: the next step promises an increase below
/// 1e-10 times (1 + abs(value)).
[[nodiscard]] Ascent climb(const SmoothFunction& function, const Eigen::VectorXd& start);
/// The same with the function at the start, if it is known.
[[nodiscard]] Ascent climb(const SmoothFunction& function, const Eigen::VectorXd& start, LocalShape at_start);

/// The trials of one record.
struct RecordCounts {
  std::vector<ProbitCounts> counts;
  double weight = 1.0;  ///< how many times the record counts: in a bootstrap sample an integer >= 0
};

/// The parameters (a, b, t), in this order, as a vector.
using MixedProbitParameters = Eigen::Vector3d;

/// Logarithm of the likelihood of one record, without binomial coefficients, with its derivatives by (a, b, t).
///
///     L = integral of phi(z) prod_l Phi(eta_l)^k_l (1 - Phi(eta_l))^(n_l - k_l) dz,   eta_l = a + b u_l + t z
///
/// Adaptive Gauss-Hermite quadrature with 25 nodes, centred at the mode of the integrand and scaled by its curvature
/// there (Liu & Pierce 1994, Biometrika 81, 624-629). Where 25 and 11 nodes differ by more than 1e-4, as for a record
/// whose outcomes are a step (the integrand is then flat between two levels), the integral is taken over intervals
/// that are halved until Gauss-Legendre rules with 15 nodes agree to 1e-8 of it, at most 60 times on each side.
/// Derivatives are those under the
/// integral, by the same nodes (Louis 1982, J. R. Stat. Soc. B 44, 226-233).
[[nodiscard]] LocalShape record_log_likelihood(std::span<const ProbitCounts> record,
                                               const MixedProbitParameters& parameters);

/// The sum over the records, each by its weight.
[[nodiscard]] LocalShape mixed_probit_log_likelihood(const std::vector<RecordCounts>& records,
                                                     const MixedProbitParameters& parameters);

/// Where a search for the largest likelihood starts, with that of each record there. The same for every choice of weights.
struct MixedProbitStart {
  MixedProbitParameters at;
  std::vector<LocalShape> records;
};
[[nodiscard]] MixedProbitStart mixed_probit_start(const std::vector<RecordCounts>& records,
                                                  const MixedProbitParameters& at);

/// The parameters of the largest likelihood, t >= 0, from the best of four starts with different t, or from `start`.
/// t is exactly 0 where no t > 0 increases the likelihood. Needs all records together to have the shape `has_maximum`,
/// and a record whose outcomes are no step.
[[nodiscard]] Ascent most_likely_mixed_probit(const std::vector<RecordCounts>& records);
[[nodiscard]] Ascent most_likely_mixed_probit(const std::vector<RecordCounts>& records, const MixedProbitStart& start);

/// The counts of all records together, by growing u.
[[nodiscard]] std::vector<ProbitCounts> pooled_counts(const std::vector<RecordCounts>& records);

// Records whose outcomes are steps: no event up to some u, only events from the next one on. The limit of the mixed
// probit without scatter within a record: each record has one capacity, known to lie between two values of u.

/// Where the capacity of a record lies.
struct CapacityRange {
  double low = -std::numeric_limits<double>::infinity();  ///< largest u without an event
  double high = std::numeric_limits<double>::infinity();  ///< smallest u with one
  double weight = 1.0;                                    ///< how many times the record counts
};

/// The ranges, if every record is a step; absent if one has both outcomes at one u, or an event below a u without one.
[[nodiscard]] std::optional<std::vector<CapacityRange>> capacity_ranges(const std::vector<RecordCounts>& records);

/// Whether one capacity of all records is possible: then the likelihood has no maximum.
[[nodiscard]] bool have_a_common_capacity(const std::vector<CapacityRange>& ranges);

/// Logarithm of the likelihood of (a, b), P(capacity <= u) = Phi(a + b u): the sum of ln(Phi(a + b high) -
/// Phi(a + b low)), with its derivatives. Concave (Burridge 1981, J. R. Stat. Soc. B 43, 41-45).
[[nodiscard]] LocalShape capacity_log_likelihood(const std::vector<CapacityRange>& ranges, const Eigen::Vector2d& line);

/// A node and its weight in the integral of exp(-x^2) f(x) over all x.
struct QuadratureNode {
  double x = 0.0;
  double weight = 0.0;
};

/// The rule with `nodes` >= 1 nodes that is exact for polynomials f of degree 2 nodes - 1, by growing x.
///
/// Nodes are the eigenvalues of the Jacobi matrix of the Hermite polynomials; weights are sqrt(pi) times the squares of
/// the first components of its eigenvectors. Source: Golub & Welsch (1969), Math. Comp. 23, 221-230.
[[nodiscard]] std::vector<QuadratureNode> gauss_hermite(std::size_t nodes);

}  // namespace rocking::stats
