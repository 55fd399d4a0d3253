#pragma once

#include <cstdint>
#include <vector>

namespace rocking::stats {

/// The lognormal law of a suite of records: the capacity of a trial is the product of two independent lognormal numbers,
/// one of its record and one of its own.
///
///     P(event at x | record) = Phi((ln x - ln median - z between_records)/within_record),   z ~ N(0, 1)
///     P(event at x)          = Phi((ln x - ln median)/dispersion),   dispersion^2 = between_records^2 + within_record^2
struct SuiteLaw {
  double median = 1.0;
  double between_records = 0.0;  ///< >= 0
  double within_record = 0.0;    ///< >= 0; exactly 0 where the outcomes of every record are a step
  double log_likelihood = 0.0;   ///< without binomial coefficients

  [[nodiscard]] double dispersion() const;
  /// For a record drawn at random.
  [[nodiscard]] double probability(double intensity) const;
};

/// The parameters of a law that have intervals.
enum class SuiteQuantity : std::uint8_t { median, dispersion, between_records, within_record };
[[nodiscard]] double value_of(SuiteQuantity quantity, const SuiteLaw& law);

/// The pooled law of Baker (2015), Earthquake Spectra 31, 579-599: one probit for the trials of all records, which are
/// counted as independent.
struct PooledLaw {
  double median = 1.0;
  double dispersion = 0.0;
  double log_likelihood = 0.0;
  double deviance = 0.0;  ///< from a probability of its own at each intensity
};

/// How the capacities of records depend on a number of each record.
struct SuiteCovariate {
  double slope = 0.0;    ///< change of ln capacity with the number
  double p_value = 1.0;  ///< of the slope 0
};

/// Laws of bootstrap samples: each draws as many records as there are, with replacement, and keeps all trials of a
/// record together. Valid whatever the dependence of trials of one record.
struct RecordBootstrap {
  std::uint64_t samples = 0;
  std::vector<SuiteLaw> laws;                ///< of the samples that have one
  std::vector<PooledLaw> pooled;             ///< likewise
  std::vector<std::vector<double>> weights;  ///< of each sample: how many times each record is in it
};

}  // namespace rocking::stats
