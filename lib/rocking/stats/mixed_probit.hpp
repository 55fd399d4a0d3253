#pragma once

#include <span>
#include <vector>

#include "rocking/stats/newton_ascent.hpp"
#include "rocking/stats/probit.hpp"

/// Probit regression with a random intercept: given z ~ N(0, 1) of its record, a trial at u has the event with
/// probability Phi(a + b u + t z), and trials are independent. Over all records P(event at u) is
/// Phi((a + b u)/sqrt(1 + t^2)).
namespace rocking::stats {

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
/// that are halved until Gauss-Legendre rules with 15 nodes agree to 1e-8 of it, at most 60 times on each side. Derivatives are those under the
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

}  // namespace rocking::stats
