#pragma once

#include "rocking/report/object_reader.hpp"

/// Every bound that the experiment file sets on a number. Bounds far outside what is physical keep the arithmetic away
/// from overflow; the others are the model's.
namespace rocking::report::rules {

inline constexpr NumberRule length{.allows = [](double x) { return x > 0.0 && 1e-6 <= x && x <= 1e6; },
                                   .demand = "must be a positive number of metres, from 1e-6 to 1e6",
                                   .example = "1.0"};
inline constexpr NumberRule gravity{.allows = [](double x) { return 1e-6 <= x && x <= 1e6; },
                                    .demand = "must be a positive number of m/s^2, from 1e-6 to 1e6",
                                    .example = "9.81",
                                    .standard = 9.81};
inline constexpr NumberRule amplitude{
    .allows = [](double x) { return 0.0 <= x && x <= 1e6; },
    .demand = "must be a number from 0 to 1e6: A_h, in units of the shape angle times gravity",
    .example = "4.2"};
inline constexpr NumberRule frequency_ratio{.allows = [](double x) { return 1e-3 <= x && x <= 1e6; },
                                            .demand = "must be a positive number from 0.001 to 1e6: Omega_h = omega/p",
                                            .example = "10.0"};
inline constexpr NumberRule scale{.allows = [](double x) { return 0.0 <= x && x <= 1e6; },
                                  .demand = "must be a number from 0 to 1e6: a factor on the recorded accelerations",
                                  .example = "1.0",
                                  .standard = 1.0};
inline constexpr NumberRule time_step{.allows = [](double x) { return 1e-9 <= x && x <= 1e6; },
                                      .demand = "must be a positive number of seconds, from 1e-9 to 1e6",
                                      .example = "0.005"};
inline constexpr NumberRule friction_coefficient{.allows = [](double x) { return 0.0 <= x && x <= 1e6; },
                                                 .demand = "must not be negative or above 1e6",
                                                 .example = "0.35"};
inline constexpr NumberRule restitution{.allows = [](double x) { return -1.0 < x && x <= 1.0; },
                                        .demand = "must be above -1 and at most 1, or be \"jy25\"",
                                        .example = "0.0"};
inline constexpr NumberRule sigma{.allows = [](double x) { return 0.0 <= x && x <= 1e6; },
                                  .demand = "must not be negative or above 1e6: a standard deviation",
                                  .example = "0.03"};
inline constexpr IntegerRule refreshes{.low = 1, .high = 100'000, .standard = 200};
inline constexpr NumberRule phase{.allows = [](double x) { return -1e3 <= x && x <= 1e3; },
                                  .demand = "must be a number of radians from -1000 to 1000",
                                  .example = "0.0"};
inline constexpr NumberRule initial_value{.allows = [](double x) { return -1e6 <= x && x <= 1e6; },
                                          .demand = "must be a number from -1e6 to 1e6",
                                          .example = "0.0"};
inline constexpr IntegerRule transient_periods{.low = 0, .high = 100'000'000, .standard = 500};
inline constexpr IntegerRule sampled_periods{.low = 1, .high = 1'000'000, .standard = 120};
inline constexpr NumberRule tolerance{.allows = [](double x) { return 1e-16 <= x && x <= 1e-2; },
                                      .demand = "must be a number from 1e-16 to 1e-2",
                                      .example = "1e-13",
                                      .standard = 1e-13};
inline constexpr IntegerRule repeat_every{.low = 0, .high = 1'000'000'000, .standard = 10};
inline constexpr IntegerRule realisations{.low = 1, .high = 1'000'000'000, .standard = 1};
inline constexpr IntegerRule check_every{.low = 1, .high = 1'000'000'000, .standard = 20};
inline constexpr IntegerRule times_longer{.low = 2, .high = 1'000, .standard = 20};
inline constexpr IntegerRule at_most{.low = 1, .high = 1'000'000'000};
inline constexpr NumberRule half_width{.allows = [](double x) { return 1e-4 <= x && x < 0.5; },
                                       .demand = "must be a number from 0.0001 to below 0.5: of every mode's interval",
                                       .example = "0.02"};
inline constexpr NumberRule confidence{.allows = [](double x) { return 0.0 < x && x < 1.0; },
                                       .demand = "must be above 0 and below 1",
                                       .example = "0.95",
                                       .standard = 0.95};

}  // namespace rocking::report::rules
