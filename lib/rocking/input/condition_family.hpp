#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// The only entry of a sweep, where its values are numbers.
struct SweptNumber {
  std::string pointer;         ///< JSON pointer
  std::vector<double> values;  ///< by condition
};

/// Absent if an experiment sweeps nothing, more than one entry, or one with other values.
[[nodiscard]] std::optional<SweptNumber> only_swept_number(const Experiment& experiment);

/// An experiment's only condition with other values at some places. Its sweep is left aside.
class ConditionMaker {
 public:
  explicit ConditionMaker(const Experiment& experiment, Surroundings surroundings = {});

  /// Throws base::InputError where a value is not allowed.
  [[nodiscard]] Condition operator()(const std::vector<Parameter>& values) const;
  /// The same by setting numbers in the condition as it was once read. Absent where a value is not allowed or is no
  /// number, and where more than these numbers follows from them: a ground motion and its scale, standard deviations
  /// relative to a mean, a horizon that is not stated.
  [[nodiscard]] std::optional<Condition> set(const std::vector<Parameter>& values) const;
  /// The same by reading the whole experiment.
  [[nodiscard]] Condition read(const std::vector<Parameter>& values) const;

  /// The number at a place; absent where there is none.
  [[nodiscard]] std::optional<double> number(const std::string& pointer) const;

 private:
  Json document_;
  Surroundings surroundings_;
  std::optional<Condition> read_once_;  ///< absent where more follows from its numbers
};

/// The experiment's condition at any value of its only swept number; absent where the value is not allowed.
[[nodiscard]] std::function<std::optional<Condition>(double value)> condition_family(const Experiment& experiment,
                                                                                     const std::string& pointer);

/// Reads the conditions of a canonical experiment one by one, without looking at the files of ground motions.
class ConditionReader {
 public:
  /// `experiment`: null, if it was made in C++; its conditions have their parameters alone.
  explicit ConditionReader(const Json& experiment);
  /// The condition at these values of the sweep. Throws base::InputError, at `place`, where there is none.
  [[nodiscard]] Condition read(std::vector<Parameter> parameters, const std::string& place);

 private:
  Json document_;
  std::map<std::string, Json> records_;  ///< of its suite, by the names of their files
};

}  // namespace rocking
