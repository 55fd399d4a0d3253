#pragma once

#include <cstdint>
#include <optional>
#include <vector>

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

}  // namespace rocking::stats
