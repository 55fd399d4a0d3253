#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// A fact about a program or its plan.
struct Fact {
  std::string name;  ///< as a JSON key
  std::variant<std::string, std::vector<std::string>, std::uint64_t, double, bool> value;
};

/// A JSON object of the facts in their order.
[[nodiscard]] std::string facts_text(std::span<const Fact> facts);

/// A valid experiment: `valid`, `conditions`, `sha256`, `experiment` with every default written out.
[[nodiscard]] std::string validation_text(const Experiment& experiment);

/// Problems of an invalid one: `valid`, `problems`, each with `place`, `value`, `reason`, `remedy`.
[[nodiscard]] std::string validation_text(std::span<const base::Problem> problems);

}  // namespace rocking
