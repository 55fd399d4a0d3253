#pragma once

#include "rocking/base/many_parts.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/studies/infer/question.hpp"

/// From counted tests back to the numbers that explain them (lib/docs/infer.md).
namespace rocking {

/// Counts by point, by condition (candidates last) and by group.
using CountsAtPoints = std::vector<std::vector<std::vector<std::uint64_t>>>;

/// What is inferred from what, whatever simulates it.
struct InferenceSetting {
  std::vector<Unknown> unknowns;  ///< one to three
  CountedTests tests;
  double confidence = 0.95;      ///< of the intervals and of the region
  std::uint64_t seed = 0;        ///< of the experiment
  std::uint64_t next_tests = 5;  ///< tests of a candidate
  /// Counts of realisations at some values of the unknowns; every point and condition has as many.
  std::function<CountsAtPoints(const std::vector<std::vector<double>>& points)> simulate;
};

/// Called with the design so far when some of its points have been simulated.
using KeepDesign = std::function<void(const std::vector<infer::DesignPoint>& design)>;

/// How far a design is simulated, and from what.
struct DesignLimits {
  std::optional<double> seconds = {};            ///< [s] on the clock; absent: no limit
  std::function<double()> elapsed_seconds = {};  ///< needed with `seconds`
  std::vector<infer::DesignPoint> earlier = {};  ///< not simulated again
  KeepDesign keep = {};
};

/// Throws base::InputError if a prior has no weight in the range of its unknown.
void check_priors(const std::vector<Unknown>& unknowns);

/// The answer of the tests. Points are added to the design until no interval moves by more than a tenth of its width.
/// It does not depend on the number of threads. When it is asked to stop, it returns the points that are finished,
/// without an answer. Each data set that is made up for the answer is a part of `how`.
///
/// Throws as check_priors.
[[nodiscard]] Inference infer_unknowns(const InferenceSetting& setting, const DesignLimits& limits,
                                       const base::ManyParts& how = {});

/// The same from a design, whose last points were not followed by others for the reason `end`: answered if the first
/// design is finished, and `end` is not that it was stopped. It depends on these arguments alone, but for `how`, of which
/// a made-up data set is a part. Throws base::Stopped if it is asked to stop.
[[nodiscard]] Inference inference_from(const InferenceSetting& setting, std::vector<infer::DesignPoint> design,
                                       InferEnd end, const base::ManyParts& how);

/// Data sets that are made up for an answer.
[[nodiscard]] std::uint64_t made_up_sets(const InferenceSetting& setting);

/// Simulates the conditions of tests and candidates at values of the unknowns of an experiment. The experiment and the
/// tests must outlive it.
class InferSimulation {
 public:
  InferSimulation(const Experiment& experiment, const CountedTests& tests, const Surroundings& surroundings,
                  const RunOptions& options);
  InferSimulation(const InferSimulation&) = delete;
  InferSimulation& operator=(const InferSimulation&) = delete;

  /// Throws base::Stopped if it is asked to stop.
  [[nodiscard]] CountsAtPoints counts_at(const std::vector<std::vector<double>>& points);

  /// Progress counts so many data sets, too, which are made up after the realisations.
  void expect_sets(std::uint64_t sets) { later_ = sets; }
  /// One of them was made up.
  void tell_set();

 private:
  [[nodiscard]] Condition condition(const TestedCondition& tested, const std::vector<double>& at) const;
  [[nodiscard]] std::vector<std::uint64_t> counts_of(const ConditionResult& result, std::uint64_t realisations) const;

  const Experiment* experiment_;
  const CountedTests* tests_;
  std::function<Condition(const std::vector<Parameter>&)> condition_at_;
  RunOptions options_;
  std::uint64_t earlier_ = 0;  ///< realisations of earlier calls
  std::uint64_t later_ = 0;    ///< data sets that will be made up
  std::uint64_t made_up_ = 0;
};

/// That of counted tests, whose points `simulation` simulates.
[[nodiscard]] InferenceSetting inference_setting(const Experiment& experiment, const CountedTests& tests,
                                                 std::uint64_t next_tests, InferSimulation& simulation);

}  // namespace rocking
