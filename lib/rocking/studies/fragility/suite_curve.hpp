#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/studies/fragility/fragility_curve.hpp"
#include "rocking/studies/fragility/stripes.hpp"

namespace rocking {

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
  stats::Proportion happened = {};
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

/// Quantiles of the peak tilt: 16, 50 and 84 %, about a standard deviation around the median of a lognormal number.
inline constexpr std::array<double, 3> peak_tilt_shares{0.16, 0.5, 0.84};

/// Quantiles of the peak tilt at one intensity, abs(Theta) [-]. An overturned block, and a realisation without an answer,
/// counts as beyond every tilt: absent where the quantile is one.
struct PeakTiltLevel {
  double intensity = 0.0;
  std::size_t trials = 0;
  std::size_t overturned = 0;
  std::array<std::optional<double>, peak_tilt_shares.size()> quantiles;
};

/// Trials that stand at an intensity and overturn at a weaker one (Vamvatsikos & Cornell 2002, Earthquake Engng Struct.
/// Dyn. 31, 491-514: structural resurrection). A trial is one realisation under one motion at all its levels.
struct Resurrections {
  std::size_t trials = 0;  ///< that stand again
  std::size_t of = 0;      ///< trials that overturn at some level
};

/// Peak tilt against intensity under one motion.
struct PeakTiltCurve {
  std::string record;  ///< empty: the experiment has one motion only
  std::vector<PeakTiltLevel> levels;
  Resurrections resurrections;
};

/// An incremental dynamic analysis.
struct IncrementalAnalysis {
  std::string parameter;
  std::vector<Parameter> others;
  std::vector<PeakTiltCurve> records;
  std::vector<PeakTiltLevel> all;  ///< of all records together, each trial of each record counted once
  Resurrections resurrections;     ///< sum over the records
};

/// Needs the peak tilts. Quantile q of n ordered numbers is number ceil(q n), counted from 1.
[[nodiscard]] IncrementalAnalysis incremental_analysis(const StripeGroup& group);

/// Those of the intensity, and PGV/PGA [s], which a record keeps at every scale.
constexpr auto names_of_surface_measures() {
  std::array<std::string_view, intensity_measure_names.size() + 1> names{};
  for (std::size_t i = 0; i < intensity_measure_names.size(); ++i) names[i] = intensity_measure_names[i];
  names.back() = "pgv_over_pga_s";
  return names;
}

/// Measures over which a surface stands.
inline constexpr auto surface_measure_names = names_of_surface_measures();

struct SurfaceCoefficient {
  std::string term;  ///< `1`, `ln x`, `ln y`, `ln x ln y`
  double value = 0.0;
  std::optional<stats::Interval> interval;  ///< by bootstrap over records; absent: too few samples
};

/// The x at which the probability is 1/2, at a quartile of the tested y.
struct SurfaceMedian {
  double y = 0.0;
  std::optional<double> x;                  ///< absent: the probability does not rise with x
  std::optional<stats::Interval> interval;  ///< of it
  bool is_extrapolated = false;             ///< outside the tested points
};

struct SurfacePoint {
  double x = 0.0, y = 0.0;
  double probability = 0.0;
  std::optional<stats::Interval> interval;
  bool is_extrapolated = false;  ///< outside the convex hull of the tested points in (ln x, ln y)
};

/// A record at a level.
struct TestedPoint {
  std::string record;
  double x = 0.0, y = 0.0;
  stats::Proportion overturned;
};

/// Mean annual rate of the event by a joint hazard: the sum over its cells of rate times probability.
struct SurfaceRate {
  std::string hazard;  ///< name of its file
  double value = 0.0;  ///< [1/year]
  std::optional<stats::Interval> interval;
  double extrapolated_share = 0.0;  ///< from cells outside the tested points
};

/// What a surface takes from outside its tested points without a warning.
inline constexpr double most_extrapolated_surface = 0.05;

/// P = Phi(c0 + c1 ln x + c2 ln y + c3 ln x ln y), the logarithms less those of the centre.
struct FragilitySurface {
  CurveSubject subject;
  std::array<std::string, 2> measures;  ///< x, y
  stats::FragilityOutcome outcome = stats::FragilityOutcome::fitted;
  std::array<double, 2> centre{};  ///< geometric means over the tested points; this and the rest only if `fitted`
  std::vector<SurfaceCoefficient> coefficients = {};  ///< without that of `ln x ln y` if its test does not ask for it
  double log_likelihood = 0.0;
  std::optional<stats::SurfaceTest> interaction = std::nullopt, second = std::nullopt;
  std::vector<SurfaceMedian> medians = {};  ///< at the lower and the upper quartile of y
  std::vector<SurfacePoint> map = {};       ///< row by row: by growing y, then by growing x
  std::vector<TestedPoint> tested = {};
  std::optional<SurfaceRate> rate = std::nullopt;  ///< with a joint hazard

  /// Zero for a term that is not there.
  [[nodiscard]] stats::SurfaceCoefficients values() const;
};

}  // namespace rocking
