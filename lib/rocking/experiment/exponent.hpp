#pragma once

#include <cstdint>
#include <optional>

#include "rocking/experiment/realisation.hpp"
#include "rocking/section/classify.hpp"

namespace rocking::experiment {

/// What two copies under the same draws tell, and what it cost.
struct CompanionRun {
  std::optional<section::ExponentEstimate> exponent;  ///< absent: the run ended too early
  std::uint64_t periods = 0;                          ///< run, both copies together
};

/// Largest Lyapunov exponent per excitation period, from a companion displaced by 1e-7 under the same draws and put back
/// to that distance at every strobe point. The companion passes through events of its own, so that the saltation at them
/// is in its distance. `from`: a realisation at the end of its transient; it is run on over `periods` more, and over up to
/// eight times as many while the exponent is not clear of zero.
///
/// The standard error is that of the mean of eight batches in a row.
/// Source: Benettin, Galgani, Giorgilli & Strelcyn (1980), Meccanica 15, 9-20.
[[nodiscard]] CompanionRun companion_exponent(const Motion<dynamics::HarmonicExcitation>& from, double shape_angle,
                                              std::int64_t periods);

}  // namespace rocking::experiment
