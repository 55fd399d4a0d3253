#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "rocking/output/report.hpp"

/// Numbers about all conditions of a report together, which the page and its tables write.
namespace rocking {

/// Realisations of all conditions.
[[nodiscard]] std::uint64_t realisations_of(const Report& report);

/// How common a response mode is.
struct Prevalence {
  /// Conditions in which it is the most frequent mode; of equally frequent modes the first.
  std::uint64_t most_likely = 0;
  std::uint64_t occurs = 0;        ///< conditions in which it occurs
  std::uint64_t realisations = 0;  ///< of all conditions
};

/// Of each mode that occurs.
[[nodiscard]] std::map<section::ResponseMode, Prevalence> prevalences_of(const Report& report);

/// The condition in which a mode is most frequent; if it never occurs, the one in which its interval reaches highest.
[[nodiscard]] std::size_t extreme_of(const Report& report, const section::ResponseMode& mode);

/// How repeatable responses are.
struct Repeatability {
  std::uint64_t compared = 0;        ///< conditions with two or more realisations
  std::uint64_t alike = 0;           ///< those of them in which all realisations have the same mode
  std::optional<std::size_t> least;  ///< the condition whose runs differ most often; absent if none is compared
};
[[nodiscard]] Repeatability repeatability_of(const Report& report);

/// Pairs of runs of all conditions.
struct PooledDivergence {
  std::uint64_t pairs = 0;
  std::uint64_t diverged = 0;
  std::optional<double> median;  ///< over the conditions, of their median divergence times [periods]; the upper of two
};
[[nodiscard]] PooledDivergence pooled_divergence(const Report& report, DivergenceTimes NonRecurrence::*cause);

/// Unresolved responses of all conditions.
struct UnresolvedResponses {
  std::uint64_t count = 0;
  double share = 0.0;          ///< of all realisations
  double largest_share = 0.0;  ///< of the realisations of one condition
  std::size_t where = 0;       ///< that condition
};
[[nodiscard]] UnresolvedResponses unresolved_responses(const Report& report);

/// Half-width of the widest interval of any mode in any condition.
[[nodiscard]] double widest_half_width(const Report& report);

}  // namespace rocking
