#pragma once

#include <filesystem>

#include "rocking/api/run.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/studies/curves/annual_rate.hpp"
#include "rocking/studies/incremental/incremental.hpp"

/// Probability of overturning against intensity.
namespace rocking {

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
  std::string name = {};                            ///< tells the run from others of the same title
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

/// Reads rates of occurrence over two measures: lines of both and `annual_rate`, of which the first names the columns.
/// `measures`: as they are asked for, x and y. Throws base::InputError with the line of a fault, and std::system_error
/// where the file cannot be read.
[[nodiscard]] ROCKING_API JointHazard joint_hazard(const std::filesystem::path& file,
                                                   const std::vector<std::string>& measures);

}  // namespace rocking
