#pragma once

#include <filesystem>

#include "rocking/api/experiment.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/studies/curves/fragility_curve.hpp"

namespace rocking {

/// The part of a rate that comes from a range of intensity.
struct RateInRange {
  double from = 0.0;         ///< lower end of the range
  std::optional<double> to;  ///< upper end; absent: no end
  double rate = 0.0;         ///< [1/year]
  double share = 0.0;        ///< of the whole rate
  bool is_tested = false;    ///< lies between the lowest level that can lift the block and the highest level
};

/// Probability that the event happens within a time, if earthquakes follow each other as a Poisson process.
struct RateInYears {
  double years = 0.0;
  double probability = 0.0;                 ///< 1 - exp(-rate years)
  std::optional<stats::Interval> interval;  ///< that of the rate; absent where it is
};

/// Where the probabilities of a rate come from.
enum class RateSource : std::uint8_t {
  law,       ///< the fitted function
  levels,    ///< of one motion without a function: the levels, interpolated linearly in ln x
  isotonic,  ///< of a suite: the nearest means of shares that do not decrease, interpolated linearly in ln x
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 3> rate_source_names{"law", "levels", "isotonic"};
[[nodiscard]] constexpr std::string_view to_string(RateSource source) {
  return rate_source_names[static_cast<std::size_t>(source)];
}

/// Mean annual rate of the event. Where the least intensity that lifts the block is known, it counts from there on.
struct AnnualRate {
  double value = 0.0;                       ///< [1/year]
  std::optional<stats::Interval> interval;  ///< of the uncertainty of the probabilities; the hazard is taken as exact
  RateSource source = RateSource::law;
  /// What the law, or the levels of one motion without a law, gives below the least intensity that lifts the block; not
  /// part of `value` [1/year].
  double impossible = 0.0;
  double below_levels = 0.0;          ///< the part of `value` below the lowest level that can lift the block [1/year]
  std::vector<RateInRange> by_level;  ///< between neighbouring levels, and beyond them; by growing intensity
  double untested_share = 0.0;        ///< of the ranges that are not tested
  double probability_at_first = 0.0;  ///< at the lowest intensity of the hazard curve, below which nothing is counted
  /// Below this intensity rare estimates give the probabilities, on a probit scale linear in ln x; absent: nowhere.
  std::optional<double> rare_below;
  std::optional<RareUse> rare_use;   ///< absent: there are no rare estimates
  double extrapolated_hazard = 0.0;  ///< share of `value` from beyond the last point of the hazard curve
  double within_hazard = 0.0;        ///< the rest of `value` [1/year]
  std::optional<double> hazard_ends =
      {};  ///< intensity from which on the rate of the hazard curve is 0; absent: nowhere
  std::optional<double> frequent_hazard = {};  ///< rate of its first point, where that is above one a year [1/year]
  std::vector<RateInYears> in_years = {};      ///< in the order in which they are asked for
};

/// A rate of a suite by one way of taking the probabilities from its outcomes.
struct RateEstimate {
  RateSource source = RateSource::law;
  double value = 0.0;  ///< [1/year]
  /// By the law: of its bootstrap samples over records. By shares: what the levels allow, with a record that is not in
  /// the suite (stats/suite_bootstrap.hpp).
  std::optional<stats::Interval> interval;
};

/// What a record contributes to the rate of a suite.
struct RateOfRecord {
  std::string name;
  double rate = 0.0;   ///< by its own shares, interpolated; the mean over the records is that by their means [1/year]
  double share = 0.0;  ///< of the sum over the records
};

/// Shares of the rate, and differences of its estimates, that are not reported without a warning.
inline constexpr double most_extrapolated_hazard = 0.05;
/// Likewise a rate of exceedance of the hazard curve, and one of the event [1/year].
inline constexpr double most_frequent_hazard = 1.0;
inline constexpr double most_frequent_event = 0.5;
inline constexpr double most_undecided_share = 0.05;
inline constexpr double most_disagreement = 0.15;

/// Mean annual rate of a suite, by the law and by isotonic shares, and what decides it. Below the least intensity that
/// lifts the block the probability is 0 in both; above the levels that by shares stays at the last one.
struct SuiteRate {
  AnnualRate chosen;                    ///< by the law where it holds for every option, else by isotonic shares
  std::vector<RateEstimate> estimates;  ///< by law (if there is one), isotonic
  /// Larger over smaller of both, less 1; 0 without a law. Absent if the smaller is 0 and the larger is not.
  std::optional<double> disagreement;
  /// The largest rate that the levels allow: below them the probability is their first share, above them 1 [1/year].
  double at_most = 0.0;
  /// Part of the isotonic rate that the levels leave open: in the ranges outside them the difference between the bounds, in
  /// those between them the difference between linear and probit interpolation.
  double undecided_share = 0.0;
  std::vector<double> add_levels;  ///< intensities that would settle it; empty if nothing is open and the rates agree
  std::vector<RateOfRecord> by_record;

  [[nodiscard]] bool do_estimates_agree() const { return disagreement && *disagreement <= most_disagreement; }
  [[nodiscard]] bool is_decided() const { return undecided_share <= most_undecided_share; }
};

/// The rate of a suite with other values of the rest of the sweep, as another width or friction of the block, against
/// that with the first ones: both by the same probabilities, and sample by sample of the bootstrap of their records. By
/// shares the intervals hold what the levels of both leave undecided.
struct RateComparison {
  std::vector<Parameter> base;
  std::vector<Parameter> option;
  ResponseEvent event;
  RateSource source = RateSource::isotonic;                ///< of both rates
  double difference = 0.0;                                 ///< rate of the option less that of the base [1/year]
  std::optional<stats::Interval> interval = std::nullopt;  ///< of the difference, by bootstrap over records
  std::optional<double> ratio = std::nullopt;  ///< rate of the option over that of the base; absent if that is 0
  std::optional<stats::Interval> ratio_interval = std::nullopt;  ///< its upper end may be infinite
};

/// Integral of P(x) |dH(x)| of a curve of one motion. With a fitted function the interval is that of the logarithm of the
/// rate by the delta method; otherwise it adds up the ends of the simultaneous intervals of the levels, on the assumption
/// that the probability does not decrease: below the lowest level 0 and above the highest 1 are possible.
[[nodiscard]] AnnualRate annual_rate(const FragilityCurve& curve, const HazardCurve& hazard);

/// Of a suite: by its law, unless it has none that holds, or by isotonic shares. The intervals are those of its bootstrap samples over records; those by shares hold what the levels leave
/// undecided (lib/docs/fragility.md).
[[nodiscard]] SuiteRate annual_rate(const SuiteCurve& curve, const HazardCurve& hazard,
                                    RateSource source = RateSource::law);

/// Compares the rates of two suites of the same records, sample by sample of their bootstraps, which draw the same records:
/// with common random numbers the difference is known better than either rate. By the law only where both have one.
[[nodiscard]] RateComparison compared_rates(const SuiteCurve& base, const SuiteCurve& option, const HazardCurve& hazard,
                                            RateSource source = RateSource::law);

/// A rare estimate, and the curve to which it belongs.
struct RareOfCurve {
  struct OfRecord {
    std::string name;  ///< of the ground motion
    RareLevel level;
  };
  std::vector<Parameter> others;  ///< CurveSubject::others
  ResponseEvent event;
  RareLevel level;                     ///< of a suite: the mean over the records
  std::vector<OfRecord> records = {};  ///< of a suite: those whose probability is not 0
};

/// The probabilities of a `rare.json` that belong to curves of a run of this experiment, for `FragilityQuestion::rare`:
/// those > 0 with the same block, motion, horizon and accuracy, at any intensity; of a suite the means over its records.
/// Throws base::InputError if there are none, if one probability is estimated twice, if estimates under some of the records
/// are missing, if the experiment has no text, or if the file is none, and std::system_error where it cannot be read.
[[nodiscard]] ROCKING_API std::vector<RareOfCurve> rare_levels(const std::filesystem::path& file,
                                                               const Experiment& experiment);

/// Of the text of a file with this name; otherwise as those of question.hpp.
[[nodiscard]] std::vector<RareOfCurve> rare_levels(const std::string& text, const std::string& name,
                                                   const Experiment& experiment);

/// The place of an estimate of a probability that one before it has estimated too: a curve would join them. Absent if there
/// is none.
[[nodiscard]] std::optional<std::size_t> second_estimate(const std::vector<RareOfCurve>& rare);

}  // namespace rocking
