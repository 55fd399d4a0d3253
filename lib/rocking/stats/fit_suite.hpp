#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/stats/fragility.hpp"

/// Laws of the capacities of a suite of records, from counts.
namespace rocking::stats {

/// Trials of one record at one intensity.
struct RecordLevel {
  double intensity = 0.0;        ///< > 0
  Proportion happened;           ///< at least one trial
  std::uint64_t unresolved = 0;  ///< trials whose outcome is not known, and stands as not happened
};

/// Levels of each record; records may have different intensities.
using SuiteLevels = std::vector<std::vector<RecordLevel>>;

/// Whether there is a law, and which: never `no_scatter`, `rejected`, `not_monotone`.
struct SuiteFit {
  FragilityOutcome outcome = FragilityOutcome::fitted;
  std::optional<SuiteLaw> law;  ///< present if and only if the outcome is `fitted`
};

/// The law of maximum likelihood. Outcomes: `too_little` with fewer than two records or two intensities; `separated` also
/// where one capacity of all records is possible.
///
/// Trials of a record are counted as independent given the record, at all levels. Method: mixed_probit.hpp, and
/// mixed_probit.hpp where the outcomes of every record are a step, since the likelihood then increases towards
/// within_record = 0.
[[nodiscard]] SuiteFit fit_suite(const SuiteLevels& suite);

/// The same, where the search starts at a law that is expected to be near: faster, as for samples of a bootstrap.
[[nodiscard]] SuiteFit fit_suite_near(const SuiteLevels& suite, const SuiteLaw& near);

/// Variance of a quantity by the scatter of the records' scores (sandwich), over that by the curvature of the likelihood;
/// at least 1. It exceeds 1 where trials of a record at several levels use common random numbers, which the likelihood
/// takes for independent. 1 at the limits without scatter within or between records.
[[nodiscard]] double excess_of_variance(const SuiteLevels& levels, const SuiteLaw& law, SuiteQuantity quantity);

/// Those values of a quantity at which the largest likelihood, over the other parameters, is at least exp(-c q^2/2) times
/// that of the law, with the quantile q of Student's distribution with (number of records - 1) degrees of freedom and c
/// the excess of variance (Rotnitzky & Jewell 1990, Biometrika 77, 485-497).
///
/// 0 or infinity where an end does not exist. For a median and for dispersions between records the information is that of
/// as many independent capacities as there are records; the quantile of the normal distribution would give intervals
/// that are too narrow for few records (reports/evidence/intervals.md has the coverage). `law` is that of fit_suite(suite).
[[nodiscard]] Interval profile_interval(const SuiteLevels& suite, const SuiteLaw& law, SuiteQuantity quantity,
                                        double confidence);

/// By maximum likelihood. Absent where the likelihood has no maximum or does not rise.
[[nodiscard]] std::optional<PooledLaw> fit_pooled(const SuiteLevels& suite);

/// A uniform number in [0, 1) for draw `number` of bootstrap sample `sample`; a pure function of both, called by several
/// threads.
using RecordDraws = std::function<double(std::uint64_t sample, std::uint64_t number)>;

/// Laws of bootstrap samples. A sample is a part.
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

}  // namespace rocking::stats
