#pragma once

namespace rocking::stats {

/// Half-width of a two-sided interval in standard errors, by Student's law; by the normal law if the degrees of freedom
/// are infinite. confidence in (0, 1), degrees_of_freedom > 0.
[[nodiscard]] double two_sided_t_quantile(double confidence, double degrees_of_freedom);

}  // namespace rocking::stats
