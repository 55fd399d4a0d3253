#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/stats/fit_suite.hpp"

/// Confidence limits of a mean over records of numbers that lie within known bounds.
///
/// The limits count one record more than there are: the upper one a record with the largest number that is thought
/// possible, the lower one a record with the least. The shares of all of them in the mean are random, uniform over what
/// sums to 1 (Dirichlet's distribution); the limits are quantiles of the mean over these shares. Of numbers that are 0 or
/// 1 they are the Clopper-Pearson limits, so that 0 of n is no certainty. Source: Gaffke (2005), Math. Methods Stat. 14,
/// 95-116; Phan, Thomas & Learned-Miller (2021), ICML, PMLR 139, 8567-8576. Limits by the true bounds of the numbers
/// covered in all laws that were tried there; a proof is not known.
namespace rocking::stats {

/// The shares of so many records, and last that of the unseen one, in a sample. Uses the draws 0 ... records of it.
[[nodiscard]] std::vector<double> shares_with_unseen(std::size_t records, std::uint64_t sample,
                                                     const RecordDraws& draws);

/// A mean over the records together with the unseen one, from the mean over the records by their shares.
[[nodiscard]] std::vector<double> mean_with_unseen(std::vector<double> mean, double share_of_unseen,
                                                   std::span<const double> unseen);

}  // namespace rocking::stats
