#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "rocking/stats/mixed_probit.hpp"

/// Records whose outcomes are steps: no event up to some u, only events from the next one on. The limit of the mixed
/// probit without scatter within a record: each record has one capacity, known to lie between two values of u.
namespace rocking::stats {

/// Where the capacity of a record lies.
struct CapacityRange {
  double low = -std::numeric_limits<double>::infinity();  ///< largest u without an event
  double high = std::numeric_limits<double>::infinity();  ///< smallest u with one
  double weight = 1.0;                                    ///< how many times the record counts
};

/// The ranges, if every record is a step; absent if one has both outcomes at one u, or an event below a u without one.
[[nodiscard]] std::optional<std::vector<CapacityRange>> capacity_ranges(const std::vector<RecordCounts>& records);

/// Whether one capacity of all records is possible: then the likelihood has no maximum.
[[nodiscard]] bool have_a_common_capacity(const std::vector<CapacityRange>& ranges);

/// Logarithm of the likelihood of (a, b), P(capacity <= u) = Phi(a + b u): the sum of ln(Phi(a + b high) -
/// Phi(a + b low)), with its derivatives. Concave (Burridge 1981, J. R. Stat. Soc. B 43, 41-45).
[[nodiscard]] LocalShape capacity_log_likelihood(const std::vector<CapacityRange>& ranges, const Eigen::Vector2d& line);

}  // namespace rocking::stats
