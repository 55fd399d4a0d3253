#pragma once

#include <filesystem>

#include "rocking/api/run.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/studies/fragility/fragility_curve.hpp"
#include "rocking/studies/fragility/stripes.hpp"
#include "rocking/studies/fragility/suite_curve.hpp"

/// Probability of overturning against intensity.
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
  AnnualRate chosen;                    ///< by the RateBasis
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

/// What gives the probabilities of the rate of a suite.
enum class RateBasis : std::uint8_t {
  law_if_fitted,  ///< the law, unless there is none or it is rejected; then the isotonic shares
  isotonic,       ///< these, as where the law does not hold for every option
};

/// Of a suite. The intervals are those of its bootstrap samples over records; those by shares hold what the levels leave
/// undecided (lib/docs/fragility.md).
[[nodiscard]] SuiteRate annual_rate(const SuiteCurve& curve, const HazardCurve& hazard,
                                    RateBasis basis = RateBasis::law_if_fitted);

/// The swept intensity with the periods that the experiment states, as a hazard curve names it: `sa_g[0.5]`; empty if
/// none is swept.
[[nodiscard]] std::string swept_measure(const Experiment& experiment);
/// The periods of the spectral acceleration that is swept [s]; empty: none.
[[nodiscard]] std::vector<double> measure_periods(const Experiment& experiment);

struct RunOptions;

/// The curve of one motion; with the annual rate where a hazard curve is given.
struct ShownCurve {
  FragilityCurve curve;
  std::optional<AnnualRate> rate = std::nullopt;
};

/// The curve of a suite; with the annual rate where a hazard curve is given.
struct ShownSuite {
  SuiteCurve curve;
  std::optional<SuiteRate> rate = std::nullopt;
  std::optional<FragilitySurface> surface = std::nullopt;  ///< where one is asked for
};

/// A block that has survived, under one hazard curve.
struct SurvivingBlock {
  std::string name;
  double rate = 0.0;  ///< of the event [1/year]
  std::optional<stats::Interval> rate_interval;
  double probability = 0.0;  ///< that it has not had the event: exp(-rate years)
  std::optional<stats::Interval> interval;
};

/// A hazard curve, and how likely it makes that all blocks still stand.
struct SurvivalBranch {
  std::string hazard;  ///< name of its file
  std::vector<SurvivingBlock> blocks;
  /// That none of them has had the event: that of the rate at which any has it, whose probability at a level is, record by
  /// record, 1 - prod(1 - P of a block). Its probability is the likelihood of the branch.
  SurvivingBlock all;
  double independent = 0.0;  ///< product of the probabilities of the blocks, as if each had earthquakes of its own
  double weight = 0.0;       ///< likelihood over the sum over the branches; 0 where all are 0
};

/// The probability that blocks still stand after a time, or have not had another event.
struct Survival {
  ResponseEvent event;
  double years = 0.0;
  RateSource source = RateSource::law;  ///< of all rates of a branch
  std::vector<SurvivalBranch> branches;
};

/// The curves of a run.
struct RunFragility {
  Experiment experiment;
  std::vector<ShownCurve> curves = {};
  std::vector<ShownSuite> suites = {};
  std::vector<IncrementalAnalysis> incremental = {};
  std::vector<RateComparison> comparisons = {};     ///< of suites with a hazard curve, with the first of each event
  std::optional<Survival> survival = std::nullopt;  ///< where it is asked for, of this run or of all together
};

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

/// What is asked of a run.
struct FragilityQuestion {
  std::vector<ResponseEvent> events = {};  ///< of which the probability is asked; empty: overturning
  std::optional<HazardCurve> hazard = {};  ///< gives the mean annual rates
  std::vector<double> years = {};          ///< also the probabilities within these times; > 0
  std::vector<RareOfCurve> rare = {};      ///< small probabilities of the same blocks under the same motions
  bool incremental = false;                ///< also the peak tilt against intensity for each record
  std::vector<std::string> surface = {};   ///< two of surface_measure_names: also the surface of suites over both
  std::optional<JointHazard> joint_hazard = std::nullopt;  ///< of these two; gives the annual rate of the surface
};

/// Probability of each event as a function of the swept intensity, and what else is asked. Throws base::InputError if
/// the experiment sweeps no intensity, if slip is asked of a block without friction, has no fixed number of realisations, or is not finished, or if a number is out
/// of range, and base::Stopped if it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution;
/// progress counts parts of about equal work.
[[nodiscard]] ROCKING_API RunFragility fragility(const Experiment& experiment, const RunResult& run,
                                                 const FragilityQuestion& question = {},
                                                 const Execution& execution = {});

/// The same as JSON text (`rocking.fragility/1`).
[[nodiscard]] ROCKING_API std::string fragility_text(const RunFragility& found);

/// Reads a hazard curve: a line with an intensity and its annual rate, or probability, of exceedance for each point; the
/// first line names both (lib/docs/formats.md). `reading`: what the file leaves open. Throws base::InputError with the
/// line of a fault, and std::system_error where the file cannot be read.
[[nodiscard]] ROCKING_API HazardCurve hazard_curve(const std::filesystem::path& file,
                                                   const HazardReading& reading = {});
/// The same of a text; `name` stands for its file.
[[nodiscard]] ROCKING_API HazardCurve hazard_curve_in(std::string_view text, const std::string& name,
                                                      const HazardReading& reading = {});

/// What a sheet states beside the results. Without project and date it has lines to write them on.
struct SheetNotes {
  std::string command;  ///< what makes the sheet again
  std::string project = "";
  std::string date = "";
};

/// Writes the answer about a suite of ground motions as one page of A4: HTML, or PDF if the name of the file ends with
/// `.pdf`, which WeasyPrint makes. `found`: with annual rates, by this hazard curve. If WeasyPrint
/// is missing, no file is written. Throws base::InputError if there is no suite with a rate; otherwise as write_page, and
/// like it needs a library with pages.
[[nodiscard]] ROCKING_API Written write_sheet(const StoredRun& stored, const RunFragility& found,
                                              const HazardCurve& hazard, const std::filesystem::path& file,
                                              const SheetNotes& notes = {}, const Execution& execution = {});

/// The probabilities of a `rare.json` that belong to curves of a run of this experiment, for `FragilityQuestion::rare`:
/// those > 0 with the same block, motion, horizon and accuracy, at any intensity; of a suite the means over its records.
/// Throws base::InputError if there are none, if one probability is estimated twice, if estimates under some of the records
/// are missing, if the experiment has no text, or if the file is none, and std::system_error where it cannot be read.
[[nodiscard]] ROCKING_API std::vector<RareOfCurve> rare_levels(const std::filesystem::path& file,
                                                               const Experiment& experiment);

/// Reads rates of occurrence over two measures: lines of both and `annual_rate`, of which the first names the columns.
/// `measures`: as they are asked for, x and y. Throws base::InputError with the line of a fault, and std::system_error
/// where the file cannot be read.
[[nodiscard]] ROCKING_API JointHazard joint_hazard(const std::filesystem::path& file,
                                                   const std::vector<std::string>& measures);

}  // namespace rocking
