#pragma once

#include "rocking/base/number_rule.hpp"
#include "rocking/scene/experiment.hpp"

/// Every bound on a number of a condition, whether it comes from an experiment file or from C++. Bounds far outside
/// what is physical keep the arithmetic away from overflow; the others are the model's. Defaults are the member
/// initialisers of scene/experiment.hpp.
namespace rocking::rules {

inline constexpr NumberRule length{.bounds = {.least = least_length, .most = largest_length},
                                   .demand = "must be a positive number of metres, from 1e-6 to 1e6",
                                   .example = "1.0"};
inline constexpr NumberRule offset{
    .bounds = {.least = -1e6, .most = 1e6}, .demand = "must be a number of metres, from -1e6 to 1e6", .example = "0.1"};
inline constexpr NumberRule bottom{
    .bounds = {.least = 0.0, .most = 1e6},
    .demand = "must be a number of metres from 0 to 1e6: no part reaches below the floor",
    .example = "0.0"};
inline constexpr NumberRule mass{.bounds = {.least = 1e-9, .most = 1e12},
                                 .demand = "must be a positive number of kilograms, from 1e-9 to 1e12",
                                 .example = "100.0"};
inline constexpr NumberRule gravity{.bounds = {.least = 1e-6, .most = 1e6},
                                    .demand = "must be a positive number of m/s^2, from 1e-6 to 1e6",
                                    .example = "9.81"};
inline constexpr double largest_amplitude = 1e6;  ///< A_h
inline constexpr NumberRule amplitude{
    .bounds = {.least = 0.0, .most = largest_amplitude},
    .demand = "must be a number from 0 to 1e6: A_h, in units of the shape angle times gravity",
    .example = "4.2"};
inline constexpr NumberRule amplitude_g{.bounds = {.least = 0.0, .most = 1e6},
                                        .demand = "must be a number from 0 to 1e6: the base acceleration over gravity",
                                        .example = "0.4"};
inline constexpr NumberRule amplitude_m_s2{
    .bounds = {.least = 0.0, .most = 1e6}, .demand = "must be a number of m/s^2 from 0 to 1e6", .example = "4.0"};
inline constexpr double least_frequency_ratio = 1e-3;
inline constexpr double largest_frequency_ratio = 1e6;
inline constexpr NumberRule frequency_ratio{.bounds = {.least = least_frequency_ratio, .most = largest_frequency_ratio},
                                            .demand = "must be a positive number from 0.001 to 1e6: Omega_h = omega/p",
                                            .example = "10.0"};
inline constexpr NumberRule frequency_hz{.bounds = {.least = 1e-6, .most = 1e6},
                                         .demand = "must be a positive number of Hz, from 1e-6 to 1e6",
                                         .example = "3.0"};
inline constexpr NumberRule period_s{.bounds = {.least = 1e-6, .most = 1e6},
                                     .demand = "must be a positive number of seconds, from 1e-6 to 1e6",
                                     .example = "0.5"};
inline constexpr NumberRule scale{.bounds = {.least = 0.0, .most = 1e6},
                                  .demand = "must be a number from 0 to 1e6: a factor on the recorded accelerations",
                                  .example = "1.0"};
inline constexpr NumberRule selected_number{
    .bounds = {.above = 0.0, .most = 1e6}, .demand = "must be positive, at most 1e6", .example = "1.5"};
inline constexpr NumberRule magnitude{
    .bounds = {.least = 0.0, .most = 10.0}, .demand = "is not a magnitude from 0 to 10", .example = "6.5"};
inline constexpr NumberRule pga_g{.bounds = {.least = 0.0, .most = 1e6},
                                  .demand = "must be a number from 0 to 1e6: the peak acceleration over gravity",
                                  .example = "0.4"};
inline constexpr NumberRule pgv_m_s{.bounds = {.least = 0.0, .most = 1e6},
                                    .demand = "must be a number of m/s from 0 to 1e6: the peak velocity",
                                    .example = "0.5"};
inline constexpr NumberRule oscillator_period_s{.bounds = {.least = 0.01, .most = 100.0},
                                                .demand = "must be a period in seconds, from 0.01 to 100",
                                                .example = "1.0"};
inline constexpr NumberRule time_step{.bounds = {.least = 1e-9, .most = 1e6},
                                      .demand = "must be a positive number of seconds, from 1e-9 to 1e6",
                                      .example = "0.005"};
inline constexpr NumberRule friction_coefficient{
    .bounds = {.least = 0.0, .most = 1e6}, .demand = "must not be negative or above 1e6", .example = "0.35"};
inline constexpr NumberRule restitution{.bounds = {.above = -1.0, .most = 1.0},
                                        .demand = "must be above -1 and at most 1, or be \"jy25\"",
                                        .example = "0.0"};
inline constexpr NumberRule rate_ratio{
    .bounds = {.least = 0.0, .below = 1.0},
    .demand = "must be a number from 0 to below 1: the ratio abs(w2/w1) of the tilt rates across an impact",
    .example = "0.93"};
inline constexpr NumberRule sigma{.bounds = {.least = 0.0, .most = 1e6},
                                  .demand = "must not be negative or above 1e6: a standard deviation",
                                  .example = "0.03"};
inline constexpr NumberRule weight{.bounds = {.least = 0.0, .most = 1e6},
                                   .demand = "must not be negative or above 1e6: a relative frequency",
                                   .example = "1.0"};
inline constexpr NumberRule kinetic_ratio{
    .bounds = {.least = 0.0, .most = 1.0}, .demand = "must be a number from 0 to 1: mu_k over mu_s", .example = "0.85"};
inline constexpr NumberRule correlation{
    .bounds = {.least = -1.0, .most = 1.0}, .demand = "must be a number from -1 to 1", .example = "1.0"};
inline constexpr IntegerRule refreshes{.low = 1, .high = 100'000, .example = 200};
inline constexpr NumberRule refresh_slip{.bounds = {.least = 1e-6, .most = 1e6},
                                         .demand = "must be a positive number of metres, from 1e-6 to 1e6",
                                         .example = "0.001"};
inline constexpr NumberRule phase{.bounds = {.least = -1e3, .most = 1e3},
                                  .demand = "must be a number of radians from -1000 to 1000",
                                  .example = "0.0"};
inline constexpr NumberRule initial_value{
    .bounds = {.least = -1e6, .most = 1e6}, .demand = "must be a number from -1e6 to 1e6", .example = "0.0"};
inline constexpr IntegerRule transient_periods{.low = 0, .high = 100'000'000, .example = 500};
inline constexpr IntegerRule sampled_periods{.low = 1, .high = 1'000'000, .example = 120};
inline constexpr IntegerRule at_most_periods{.low = 1, .high = 200'000'000, .example = 20000};
inline constexpr IntegerRule held_windows{.low = 1, .high = 1'000, .example = 1};
inline constexpr IntegerRule watch_windows{.low = 0, .high = 1'000'000, .example = 0};
inline constexpr IntegerRule long_run_every{.low = 0, .high = 1'000'000'000, .example = 0};
inline constexpr IntegerRule exponent_pause{.low = 0, .high = 1'000'000, .example = 0};
inline constexpr NumberRule tolerance{
    .bounds = {.least = 1e-16, .most = 1e-2}, .demand = "must be a number from 1e-16 to 1e-2", .example = "1e-13"};
inline constexpr IntegerRule rerun_every{.low = 0, .high = 1'000'000'000, .example = 10};
inline constexpr IntegerRule realisations{.low = 1, .high = 1'000'000'000, .example = 1};
inline constexpr IntegerRule at_most{.low = 1, .high = 1'000'000'000, .example = 1000};
inline constexpr NumberRule half_width{
    .bounds = {.least = 1e-4, .below = 0.5},
    .demand = "must be a number from 0.0001 to below 0.5: half the width of a mode's interval",
    .example = "0.02"};
inline constexpr NumberRule relative_half_width{
    .bounds = {.least = 1e-3, .below = 1.0},
    .demand = "must be a number from 0.001 to below 1: relative to the probability of the mode",
    .example = "0.1"};
inline constexpr NumberRule confidence{
    .bounds = {.above = 0.0, .below = 1.0}, .demand = "must be above 0 and below 1", .example = "0.95"};

/// Of a ground motion.
inline constexpr double latest_sample = 1e7;         ///< [s]; far beyond any shaking, safe from overflow in periods
inline constexpr double largest_acceleration = 1e6;  ///< [m/s^2]
inline constexpr std::size_t most_samples = 1'000'000;

}  // namespace rocking::rules
