#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/checks.hpp"
#include "rocking/scene/counted_tests.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/interval.hpp"

/// From counted tests back to the numbers that explain them (lib/docs/infer.md).
namespace rocking {

namespace infer {

/// Realisations at one value of the unknowns.
struct DesignPoint {
  std::vector<double> at;                          ///< values of the unknowns
  std::vector<std::vector<std::uint64_t>> counts;  ///< by condition, candidates last, and by group
};

/// A point of the profile likelihood of an unknown.
struct ProfilePoint {
  double at = 0.0;                ///< value of the unknown
  double likelihood_ratio = 1.0;  ///< the largest likelihood with this value over the largest one
};

/// A point of the joint region.
struct RegionPoint {
  std::vector<double> at;         ///< values of the unknowns
  double likelihood_ratio = 1.0;  ///< over the largest likelihood
};

}  // namespace infer

/// Which ends of its range the interval of an unknown reaches.
enum class ReachedBound : std::uint8_t { none, from, to, both };
/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> reached_bound_names{"none", "from", "to", "both"};
[[nodiscard]] constexpr std::string_view to_string(ReachedBound bound) {
  return reached_bound_names[static_cast<std::size_t>(bound)];
}

/// Bayesian answer for one unknown.
struct UnknownPosterior {
  double mean = 0.0;
  double median = 0.0;
  stats::Interval interval;  ///< with equal tails
};

/// What the tests say of one unknown, in its unit.
struct UnknownAnswer {
  double estimate = 0.0;     ///< where the likelihood is largest
  stats::Interval interval;  ///< by the profile likelihood
  ReachedBound reaches = ReachedBound::none;
  std::vector<infer::ProfilePoint> profile = {};             ///< at the values of the grid of the joint region
  std::optional<UnknownPosterior> posterior = std::nullopt;  ///< present if some unknown has a prior
};

/// Predicted against counted tests of a condition, at the estimate.
struct PredictedShares {
  std::vector<double> shares;              ///< by group
  std::vector<stats::Interval> intervals;  ///< of the counted shares: Clopper-Pearson
};

/// Whether the estimate explains the counts.
struct InferenceFit {
  double statistic = 0.0;  ///< deviance: 2 sum y ln(y/(N p))
  double p_value = 1.0;    ///< share of made-up data sets with a larger one, by parametric bootstrap
};

/// What is expected of further tests under a candidate condition.
struct CandidateGain {
  double region = 1.0;             ///< expected size of the region over the present one, geometric mean
  std::vector<double> deviations;  ///< by unknown: expected standard deviation over the present one
};

/// Why no more points were added to the design.
enum class InferEnd : std::uint8_t {
  settled,      ///< no end of an interval moved by more than a tenth of its width, twice
  most_points,  ///< the largest number of points was reached
  out_of_time,
  stopped,  ///< it was asked to stop
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> infer_end_names{"settled", "most_points", "out_of_time", "stopped"};
[[nodiscard]] constexpr std::string_view to_string(InferEnd end) {
  return infer_end_names[static_cast<std::size_t>(end)];
}

/// The answer, once the first design is finished and unless it was stopped.
struct InferenceAnswer {
  std::vector<UnknownAnswer> unknowns;
  std::vector<infer::RegionPoint> region;  ///< points of a grid in the joint region
  double region_limit = 0.0;               ///< least likelihood ratio in the region
  double log_likelihood = 0.0;             ///< of the counts, at the estimate
  InferenceFit fit;
  std::vector<PredictedShares> predicted;  ///< by tested condition
  std::vector<CandidateGain> candidates;
};

struct Inference {
  std::vector<infer::DesignPoint> design;
  std::optional<InferenceAnswer> answer;  ///< absent if the first design was not finished, or if it was stopped
  std::uint64_t realisations = 0;         ///< of all points and conditions
  InferEnd end = InferEnd::settled;
};

/// Counted tests of an experiment's block, and how its unknowns are inferred from them.
struct InferQuestion {
  std::string tests_file = {};  ///< CSV (lib/docs/formats.md), read into `tests`; empty: they are given
  std::optional<std::string> candidates_file = {};  ///< conditions that may be tested next
  CountedTests tests = {};
  std::uint64_t next_tests = 5;        ///< tests of a candidate condition; 1 to 1000
  std::filesystem::path folder = ".";  ///< from which the files of the experiment are seen
  std::optional<double> seconds =
      {};  ///< [s] on a clock of the execution; no points are added after it. Absent: no limit
  std::vector<infer::DesignPoint> earlier = {};  ///< of an earlier answer to the same question; not simulated again
};

/// Estimates the unknowns of an experiment from counted tests, with intervals and a joint region. Uses `threads`,
/// `on_progress`, `stop` and `elapsed_seconds` of the execution; progress counts realisations, whose number grows until the
/// intervals settle, and the data sets that are made up for the answer. Throws base::Stopped if it is asked to stop, and
/// base::InputError if the experiment has no text, no unknowns, no fixed number of realisations, a suite, or a prior without
/// weight in the range of its unknown, with every number of the question that is out of range, every list of another length
/// and every parameter that is not in the experiment, and with each line of a file that is wrong. Source: lib/docs/infer.md.
[[nodiscard]] ROCKING_API Inference infer_unknowns(const Experiment& experiment, const InferQuestion& question,
                                                   const Execution& execution = {});

}  // namespace rocking
