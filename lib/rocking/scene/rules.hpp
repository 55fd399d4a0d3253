#pragma once

#include "rocking/base/rule.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"

/// Every bound on a number of a condition, whether it comes from an experiment file or from C++. Bounds far outside
/// what is physical keep the arithmetic away from overflow; the others are the model's. Defaults are the member
/// initialisers of scene/experiment.hpp.
namespace rocking::rules {

/// Both ends belong to it.
[[nodiscard]] constexpr Rule within(double least, double most, std::string_view demand, std::string_view example) {
  return {.least = least, .most = most, .demand = demand, .example = example};
}

inline constexpr Rule length =
    within(least_length, largest_length, "must be a positive number of metres, from 1e-6 to 1e6", "1.0");
inline constexpr Rule offset = within(-1e6, 1e6, "must be a number of metres, from -1e6 to 1e6", "0.1");
inline constexpr Rule bottom =
    within(0.0, 1e6, "must be a number of metres from 0 to 1e6: no part reaches below the floor", "0.0");
inline constexpr Rule mass = within(1e-9, 1e12, "must be a positive number of kilograms, from 1e-9 to 1e12", "100.0");
inline constexpr Rule gravity = within(1e-6, 1e6, "must be a positive number of m/s^2, from 1e-6 to 1e6", "9.81");
inline constexpr Rule frequency_parameter =
    within(1e-3, 1e4, "must be a positive number of rad/s, from 0.001 to 1e4", "2.14");
inline constexpr Rule slenderness =
    within(1e-6, 1.57, "must be a number of radians from 1e-6 to 1.57: arctan(B/H)", "0.25");
inline constexpr double largest_amplitude = 1e6;  ///< A_h
inline constexpr Rule amplitude = within(
    0.0, largest_amplitude, "must be a number from 0 to 1e6: A_h, in units of the shape angle times gravity", "4.2");
inline constexpr Rule amplitude_g =
    within(0.0, 1e6, "must be a number from 0 to 1e6: the base acceleration over gravity", "0.4");
inline constexpr Rule amplitude_m_s2 = within(0.0, 1e6, "must be a number of m/s^2 from 0 to 1e6", "4.0");
inline constexpr double least_frequency_ratio = 1e-3;
inline constexpr double largest_frequency_ratio = 1e6;
inline constexpr Rule frequency_ratio =
    within(least_frequency_ratio, largest_frequency_ratio,
           "must be a positive number from 0.001 to 1e6: Omega_h = omega/p", "10.0");
inline constexpr Rule frequency_hz = within(1e-6, 1e6, "must be a positive number of Hz, from 1e-6 to 1e6", "3.0");
inline constexpr Rule period_s = within(1e-6, 1e6, "must be a positive number of seconds, from 1e-6 to 1e6", "0.5");
inline constexpr Rule scale =
    within(0.0, 1e6, "must be a number from 0 to 1e6: a factor on the recorded accelerations", "1.0");
inline constexpr Rule selected_number{
    .above = 0.0, .most = 1e6, .demand = "must be positive, at most 1e6", .example = "1.5"};
inline constexpr Rule magnitude = within(0.0, 10.0, "is not a magnitude from 0 to 10", "6.5");
inline constexpr Rule pga_g =
    within(0.0, 1e6, "must be a number from 0 to 1e6: the peak acceleration over gravity", "0.4");
inline constexpr Rule pgv_m_s = within(0.0, 1e6, "must be a number of m/s from 0 to 1e6: the peak velocity", "0.5");
inline constexpr Rule oscillator_period_s = within(0.01, 100.0, "must be a period in seconds, from 0.01 to 100", "1.0");
inline constexpr Rule building_frequency_hz =
    within(0.05, 100.0, "must be a number of Hz from 0.05 to 100: the frequency of a mode", "1.5");
inline constexpr Rule damping_ratio = within(1e-3, 0.99, "must be a number from 0.001 to 0.99: over critical", "0.05");
inline constexpr Rule height_ratio =
    within(0.0, 1.0, "must be a number from 0 to 1: of the floor over that of the building", "0.8");
inline constexpr Rule mode_factor = within(-1e3, 1e3, "must be a number from -1000 to 1000", "1.2");
inline constexpr Rule uniform_modes{.least = 1, .most = most_building_modes, .example = "3"};
inline constexpr Rule time_step = within(1e-9, 1e6, "must be a positive number of seconds, from 1e-9 to 1e6", "0.005");
inline constexpr Rule friction_coefficient = within(0.0, 1e6, "must not be negative or above 1e6", "0.35");
inline constexpr Rule restitution{
    .above = -1.0, .most = 1.0, .demand = "must be above -1 and at most 1, or be \"jy25\"", .example = "0.0"};
inline constexpr Rule rate_ratio =
    within(0.0, 1.0, "must be a number from 0 to 1: the ratio abs(w2/w1) of the tilt rates across an impact", "0.93");
inline constexpr Rule wall_ratio =
    within(0.0, largest_wall_ratio, "must be a number from 0 to 0.999: the ratio abs(w2/w1) of the tilt rates", "0.5");
inline constexpr Rule sigma = within(0.0, 1e6, "must not be negative or above 1e6: a standard deviation", "0.03");
inline constexpr Rule weight = within(0.0, 1e6, "must not be negative or above 1e6: a relative frequency", "1.0");
inline constexpr Rule kinetic_ratio = within(0.0, 1.0, "must be a number from 0 to 1: mu_k over mu_s", "0.85");
inline constexpr Rule correlation = within(-1.0, 1.0, "must be a number from -1 to 1", "1.0");
inline constexpr Rule refreshes{.least = 1, .most = 100'000, .example = "200"};
inline constexpr Rule refresh_slip =
    within(1e-6, 1e6, "must be a positive number of metres, from 1e-6 to 1e6", "0.001");
inline constexpr Rule phase = within(-1e3, 1e3, "must be a number of radians from -1000 to 1000", "0.0");
inline constexpr Rule cycles = within(1.0, 1e3, "must be a number from 1 to 1000", "2.0");
inline constexpr Rule initial_value = within(-1e6, 1e6, "must be a number from -1e6 to 1e6", "0.0");
inline constexpr Rule transient_periods{.least = 0, .most = 100'000'000, .example = "500"};
inline constexpr Rule sampled_periods{.least = 1, .most = 1'000'000, .example = "120"};
inline constexpr Rule at_most_periods{.least = 1, .most = 200'000'000, .example = "20000"};
inline constexpr Rule held_windows{.least = 1, .most = 1'000, .example = "1"};
inline constexpr Rule watch_windows{.least = 0, .most = 1'000'000, .example = "0"};
inline constexpr Rule long_run_every{.least = 0, .most = 1'000'000'000, .example = "0"};
inline constexpr Rule exponent_pause{.least = 0, .most = 1'000'000, .example = "0"};
inline constexpr Rule tolerance = within(1e-16, 1e-2, "must be a number from 1e-16 to 1e-2", "1e-13");
inline constexpr Rule rerun_every{.least = 0, .most = 1'000'000'000, .example = "10"};
inline constexpr Rule realisations{.least = 1, .most = 1'000'000'000, .example = "1"};
inline constexpr Rule at_most{.least = 1, .most = 1'000'000'000, .example = "1000"};
inline constexpr Rule half_width{
    .least = 1e-4,
    .below = 0.5,
    .demand = "must be a number from 0.0001 to below 0.5: half the width of a mode's interval",
    .example = "0.02"};
inline constexpr Rule relative_half_width{
    .least = 1e-3,
    .below = 1.0,
    .demand = "must be a number from 0.001 to below 1: relative to the probability of the mode",
    .example = "0.1"};
inline constexpr Rule confidence{
    .above = 0.0, .below = 1.0, .demand = "must be above 0 and below 1", .example = "0.95"};

/// Of a ground motion.
inline constexpr double latest_sample = 1e7;         ///< [s]; far beyond any shaking, safe from overflow in periods
inline constexpr double largest_acceleration = 1e6;  ///< [m/s^2]
inline constexpr std::size_t most_samples = 1'000'000;

}  // namespace rocking::rules
