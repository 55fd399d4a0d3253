#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/counted_tests.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/infer/infer.hpp"

namespace rocking {

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

/// The question of counted tests, whose points `simulation` simulates.
[[nodiscard]] InferenceQuestion inference_question(const Experiment& experiment, const CountedTests& tests,
                                                   std::uint64_t next_tests, InferSimulation& simulation);

}  // namespace rocking
