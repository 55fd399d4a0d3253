#pragma once

#include <string>
#include <utility>

#include "rocking/input/suite.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// What is wrong with an experiment file: each problem once, though many conditions have it.
class ExperimentProblems {
 public:
  explicit ExperimentProblems(Problems problems) : problems_(std::move(problems)) {}

  [[nodiscard]] bool any() const { return !problems_.empty(); }
  /// Whether there are as many as are told: a bad sweep must not bury its first message.
  [[nodiscard]] bool are_enough() const;
  [[nodiscard]] Problems& all() { return problems_; }

  /// Adds those that are new. `where`: what their reasons end with.
  void merge(const Problems& found, const std::string& where = "");

  /// Throws InputError with them if there are any: with the flag in place of the key that it replaced, with what replaces
  /// a key that is gone or where a key stands that was written elsewhere, and with the records that can be read beside one
  /// that cannot.
  void throw_any(const Overrides& overrides, const Suite& suite);

 private:
  void name_readable_records(const Suite& suite);

  Problems problems_;
  Problems seen_;  ///< as they were found
};

}  // namespace rocking
