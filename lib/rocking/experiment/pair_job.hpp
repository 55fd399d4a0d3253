#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/realisation_crew.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/experiment/summary.hpp"
#include "rocking/experiment/work.hpp"

namespace rocking::experiment {

/// A pair under way: which runs it takes, and what is kept of them. A pure function of its arguments, whatever the order in
/// which the runs are done. Stays where it is: its tasks point into it.
class PairJob {
 public:
  /// Of a condition that has `count` realisations in all: where the pair has no second, there is one.
  PairJob(const Experiment& experiment, const Pair& pair, std::uint64_t count);
  PairJob(const PairJob&) = delete;
  PairJob& operator=(const PairJob&) = delete;

  [[nodiscard]] const Pair& pair() const { return pair_; }
  [[nodiscard]] std::span<const Task> tasks() const { return tasks_; }

  /// Takes the record of a task; true if it was the last one.
  bool accept(std::size_t task, Record record);

  /// Of the realisations, in their order, once all is accepted.
  [[nodiscard]] std::vector<Summary> summaries() const;

 private:
  enum class Purpose : std::uint8_t { itself, repeat, long_run };

  void add(Purpose purpose, const Condition& condition, std::uint64_t realisation);

  Pair pair_;
  Condition tighter_;  ///< for repeats
  Condition longer_;   ///< for checks of labels
  std::vector<Task> tasks_;
  std::vector<Purpose> purposes_;
  std::vector<std::optional<Record>> records_;  ///< by task
  std::size_t open_ = 0;
};

}  // namespace rocking::experiment
