#pragma once

#include "rocking/ensemble/result.hpp"
#include "rocking/fields/value_type.hpp"

/// A list of estimates (std::vector<ModeEstimate>) stands in a document as two objects by response mode.
namespace rocking {

/// Response mode to count.
[[nodiscard]] const ValueType& mode_counts_type();

/// Response mode to estimate and intervals; read after the counts.
[[nodiscard]] const ValueType& mode_probabilities_type();

}  // namespace rocking
