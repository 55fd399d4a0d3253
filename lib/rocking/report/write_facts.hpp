#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/experiment/experiment.hpp"

namespace rocking::report {

/// Something that a program tells about itself or its plan.
struct Fact {
  std::string name;  ///< as a JSON key
  std::variant<std::string, std::vector<std::string>, std::uint64_t, double, bool> value;
};

/// A JSON object of the facts in their order.
[[nodiscard]] std::string facts_text(std::span<const Fact> facts);

/// What a valid experiment amounts to: `valid`, `conditions`, `sha256`, `experiment` with every default written out.
[[nodiscard]] std::string validation_text(const experiment::Experiment& experiment);

/// What is wrong with one: `valid`, `problems`, each with `place`, `value`, `reason`, `remedy`.
[[nodiscard]] std::string validation_text(std::span<const base::Problem> problems);

}  // namespace rocking::report
