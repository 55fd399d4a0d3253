#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/stats/fit_suite.hpp"

/// Samples of the records of a suite, and intervals from them.
namespace rocking::stats {

/// A uniform number in [0, 1) for draw `number` of bootstrap sample `sample`; a pure function of both, called by several
/// threads.
using RecordDraws = std::function<double(std::uint64_t sample, std::uint64_t number)>;

/// Laws of bootstrap samples. Records are drawn among those with the same intensities: all of them, or those of a level. A
/// sample is a part.
[[nodiscard]] RecordBootstrap bootstrap_records(const SuiteLevels& suite, std::uint64_t samples,
                                                const RecordDraws& draws, const base::ManyParts& how = {});

/// The part of bootstrap samples that must have a law for an interval of them.
inline constexpr double least_share_with_law = 0.9;

/// Percentiles (1 -+ confidence)/2 of these numbers (Efron & Tibshirani 1993, An Introduction to the Bootstrap, section
/// 13.3); absent where fewer than nine tenths of the samples have one.
[[nodiscard]] std::optional<Interval> percentile_interval(std::vector<double> values, std::uint64_t samples,
                                                          double confidence);

/// The same with bias-corrected percentiles, Phi(2 z_0 -+ z), where Phi(z_0) is the share of the samples below the
/// estimate: a bootstrap of few records underestimates their scatter (Efron & Tibshirani 1993, section 14.3, without
/// acceleration).
[[nodiscard]] std::optional<Interval> bias_corrected_interval(std::vector<double> values, double estimate,
                                                              std::uint64_t samples, double confidence);

/// The confidence at which percentiles of bootstrap samples of so many records are taken, so that few records do not give
/// too narrow intervals: 2 Phi(q) - 1 with q = sqrt(n/(n - 1)) times the quantile of Student's distribution with n - 1
/// degrees of freedom. Source: Hesterberg (2015), The American Statistician 69, 371-386 (expanded percentiles).
[[nodiscard]] double expanded_confidence(double confidence, std::size_t records);

// Confidence limits of a mean over records of numbers that lie within known bounds.
//
// The limits count one record more than there are: the upper one a record with the largest number that is thought
// possible, the lower one a record with the least. The shares of all of them in the mean are random, uniform over what
// sums to 1 (Dirichlet's distribution); the limits are quantiles of the mean over these shares. Of numbers that are 0 or
// 1 they are the Clopper-Pearson limits, so that 0 of n is no certainty. Source: Gaffke (2005), Math. Methods Stat. 14,
// 95-116; Phan, Thomas & Learned-Miller (2021), ICML, PMLR 139, 8567-8576. Limits by the true bounds of the numbers
// covered in all laws that were tried there; a proof is not known.

/// The shares of so many records, and last that of the unseen one, in a sample. Uses the draws 0 ... records of it.
[[nodiscard]] std::vector<double> shares_with_unseen(std::size_t records, std::uint64_t sample,
                                                     const RecordDraws& draws);

/// Means over the records together with the unseen one, from the means over the records by their shares; each has a share
/// of the unseen one.
[[nodiscard]] std::vector<double> mean_with_unseen(std::vector<double> mean, std::span<const double> shares_of_unseen,
                                                   std::span<const double> unseen);

}  // namespace rocking::stats
