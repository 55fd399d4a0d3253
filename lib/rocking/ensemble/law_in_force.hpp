#pragma once

#include <optional>
#include <string_view>

#include "rocking/stats/normal_law.hpp"

namespace rocking {

/// A normal number of a scene that may be clamped, and what may limit it.
struct FluctuatingNumber {
  stats::MeanAndSigma law;
  std::optional<stats::MeanAndSigma> limit = std::nullopt;  ///< of kinetic friction: the law of static friction
  double correlation = 0.0;                                 ///< with the limit
};

/// Mean and standard deviation of a number as it is in force, after clamps of a kind (lib/docs/model.md, section 5). `key`: that
/// of the kind of clamp in a report. Absent for other kinds, and without the limit that the kind has.
[[nodiscard]] std::optional<stats::MeanAndSigma> law_in_force(const FluctuatingNumber& number, std::string_view key);

}  // namespace rocking
