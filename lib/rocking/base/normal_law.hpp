#pragma once

namespace rocking::base {

/// Density of the standard normal law, relative error below 1e-15.
[[nodiscard]] double normal_density(double x);

/// Probability that a standard normal number is above x, with the same bits on every machine. Relative error below 5e-15
/// for x <= 37; 0 beyond.
///
/// Sources: the series of Phi(x) - 1/2 in odd powers (Abramowitz & Stegun 1964, 26.2.11) up to 1.5, Laplace's continued
/// fraction (26.2.14) above.
[[nodiscard]] double normal_upper_tail(double x);

/// The x whose upper tail is `tail`, in (0, 1), as above: the inverse of normal_upper_tail. Absolute error below 1e-14,
/// relative to max(1, abs(x)). Source: Abramowitz & Stegun (1964) 26.2.23, improved by two steps of Halley's method.
[[nodiscard]] double normal_quantile_of_tail(double tail);

/// E[Z - low] of a standard normal number Z that lies between `low` and low + width, for low + width/2 >= 0 and width > 0;
/// the mirror image has the others. Relative error below 1e-14 for every `low` and `width`, since the integrals have positive
/// terms: a Gauss-Legendre rule over that part of the interval whose density is above exp(-40) of the largest.
[[nodiscard]] double normal_mean_above(double low, double width);

}  // namespace rocking::base
