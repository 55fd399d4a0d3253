#pragma once

#include "rocking/base/digest.hpp"
#include "rocking/studies/curves/stripes.hpp"

namespace rocking {

/// The run to which a curve belongs.
struct CurveRun {
  std::string title;                       ///< of its experiment, or the name of the run where several share it
  base::Sha256 experiment = {};            ///< digest of its canonical text
  std::vector<std::string> left_out = {};  ///< names of records of its suite that could not be read
};

/// The event at one intensity: overturning, or the event of the curve.
struct FragilityLevel {
  double intensity = 0.0;
  std::optional<Shaking> shaking = std::nullopt;  ///< of the condition; absent under a ground motion
  stats::Proportion overturned;
  /// Realisations without an answer (Summary::has_no_answer). They count as not overturned in `overturned` and
  /// `estimate`; the intervals also cover that all of them overturn.
  std::uint64_t unresolved = 0;
  double estimate = 0.0;                        ///< share of the realisations that overturned
  stats::Interval exact = {};                   ///< Clopper-Pearson, of this level alone
  stats::Interval simultaneous = {};            ///< Bonferroni-Clopper-Pearson over the levels of the curve
  std::optional<double> fitted = std::nullopt;  ///< by the law; absent where none is fitted
  /// Of `fitted` at this intensity alone; of `isotonic` it is `simultaneous`, which holds also if the probability decreases
  /// somewhere. Absent without both.
  std::optional<stats::Interval> band = std::nullopt;
  /// Most likely probability that does not decrease with the intensity; present where the fitted function was rejected.
  std::optional<double> isotonic = std::nullopt;

  /// Whether the fitted function lies outside the simultaneous interval.
  [[nodiscard]] bool is_missed() const;
};

/// A small probability of the event at an intensity, by `rocking rare` (lib/docs/rare.md).
struct RareLevel {
  double intensity = 0.0;
  double probability = 0.0;         ///< in (0, 1)
  stats::Interval interval = {};    ///< at its own confidence
  double relative_error = 0.0;      ///< standard error over the probability
  double degrees_of_freedom = 1.0;  ///< of the error
};

/// How far rare estimates give the probabilities of a rate.
enum class RareUse : std::uint8_t {
  below_sure_level,  ///< below the lowest level with ten events
  below_best_level,  ///< no level has so many: below the one above the estimates that has the most
  up_to_highest,     ///< no level above the estimates has an event: up to the highest estimate
  not_used,          ///< none lies below a level with ten events, or there is one alone and no level with an event
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> rare_use_names{"below_sure_level", "below_best_level", "up_to_highest",
                                                                "not_used"};
[[nodiscard]] constexpr std::string_view to_string(RareUse use) {
  return rare_use_names[static_cast<std::size_t>(use)];
}

/// The fitted function of a curve, and what follows from it at the curve's confidence and levels.
struct FittedLaw {
  stats::LognormalFragility function;
  stats::Bounded median;
  bool is_extrapolated = false;  ///< the median lies outside the levels
  stats::Bounded dispersion;
};

/// Probability of overturning as a function of intensity, from conditions that differ in nothing else.
struct FragilityCurve {
  CurveSubject subject;
  stats::FragilityOutcome outcome = stats::FragilityOutcome::fitted;
  std::optional<FittedLaw> law;          ///< present if and only if the outcome is `fitted`
  std::optional<stats::LackOfFit> test;  ///< of the fitted function; absent where none could be fitted
  std::vector<FragilityLevel> levels;    ///< by growing intensity
  std::vector<RareLevel> rare;           ///< likewise; the function is not fitted to them

  [[nodiscard]] bool has_law() const { return law.has_value(); }
  /// Whether isotonic estimates take the place of a function that was rejected.
  [[nodiscard]] bool is_isotonic() const { return outcome == stats::FragilityOutcome::rejected; }
  /// Levels at which the fitted function lies outside the simultaneous interval.
  [[nodiscard]] std::size_t missed_levels() const;
};

/// A parameter of the law of a suite.
struct SuiteEstimate {
  double value = 0.0;
  stats::Interval interval;                  ///< by profile likelihood; its upper end may be infinite
  std::optional<stats::Interval> bootstrap;  ///< over records; absent where too many samples have no law
};

/// The law of a suite with its intervals.
struct PooledSuite {
  SuiteEstimate median;
  bool is_extrapolated = false;  ///< the median lies outside the levels
  SuiteEstimate dispersion, between_records, within_record;
  double log_likelihood = 0.0;

  [[nodiscard]] stats::SuiteLaw law() const;
};

/// All records together at one intensity.
struct SuiteLevel {
  double intensity = 0.0;
  std::size_t records = 0;
  stats::Proportion overturned = {};
  std::uint64_t unresolved = 0;                        ///< FragilityLevel::unresolved, likewise
  double estimate = 0.0;                               ///< mean over the records of their shares
  std::optional<double> fitted = std::nullopt;         ///< by the law of the suite
  std::optional<stats::Interval> band = std::nullopt;  ///< of `fitted`, by bootstrap over records
  double isotonic = 0.0;               ///< the nearest to the estimates of all levels that does not decrease
  stats::Interval isotonic_band = {};  ///< of `isotonic`, by bootstrap over records
};

/// The curve of one record.
struct RecordCurve {
  std::string name;
  FragilityCurve curve;
};

/// How well a measure of intensity predicts the event: the law of the suite with this measure as its intensity.
/// Numbers are absent where no law could be fitted.
struct RankedMeasure {
  IntensityMeasure measure = IntensityMeasure::pga;
  std::optional<double> median, dispersion, between_records, within_record;
  std::optional<double> deviance;  ///< -2 ln likelihood, without binomial coefficients
  std::optional<double> aic;  ///< deviance + 2 times 3 parameters (Akaike 1974, IEEE Trans. Automat. Contr. 19, 716)
};

/// Fragility of a suite of records.
struct SuiteCurve {
  CurveSubject subject;
  stats::FragilityOutcome outcome = stats::FragilityOutcome::fitted;  ///< of the pooled law
  std::optional<PooledSuite> pooled;                                  ///< present if `fitted` or `rejected`
  std::optional<stats::LackOfFit> test;  ///< of the pooled law; absent without it or where too many samples have none
  std::vector<SuiteLevel> levels;        ///< by growing intensity
  std::vector<RareLevel> rare;           ///< means over the records, whose own stand in their curves; likewise
  std::vector<RecordCurve> records;      ///< in the order of the sweep
  std::vector<RankedMeasure> measures;   ///< best first; empty where the motions have none
  stats::RecordBootstrap bootstrap;      ///< of the records

  /// Whether the law of the suite gives its probabilities; else the isotonic shares do.
  [[nodiscard]] bool has_law() const { return pooled && outcome == stats::FragilityOutcome::fitted; }
  /// Of the level with the fewest, where levels have records of their own.
  [[nodiscard]] std::size_t records_in_sample() const { return bootstrap.fewest; }
  /// Of bootstrap samples over the records, in any order, at the curve's confidence.
  [[nodiscard]] std::optional<stats::Interval> interval_of(std::vector<double> samples) const;
  /// The same with bias-corrected percentiles, for an estimate whose samples are biased.
  [[nodiscard]] std::optional<stats::Interval> interval_about(double estimate, std::vector<double> samples) const;
  /// The same of a mean of shares, `value`. Where all samples are equal, as where no record has the event, it is the exact
  /// one of as many records: Clopper-Pearson's, since no law of a share has a larger variance than that of 0 and 1.
  [[nodiscard]] stats::Interval interval_of_share(double value, std::vector<double> samples) const;

 private:
  [[nodiscard]] double confidence_of_percentiles() const;
};

}  // namespace rocking
