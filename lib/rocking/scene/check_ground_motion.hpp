#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/scene/number_rule.hpp"

/// What the samples of a ground motion must be, for the reader of its file and for motions that come from C++.
namespace rocking {

/// `time` of a sample [s].
[[nodiscard]] std::optional<Refusal> refuse_sample_time(double time);

/// Of a sample that is earlier than the one before it, whose time is shown as `previous`.
[[nodiscard]] Refusal sample_falls_back(std::string_view previous);

/// `acceleration` in units of `unit` [m/s^2].
[[nodiscard]] std::optional<Refusal> refuse_acceleration(double acceleration, double unit = 1.0);

/// Of all samples together: their number, and the time that they take.
[[nodiscard]] std::optional<Refusal> refuse_samples(const std::vector<dynamics::GroundMotionSample>& samples);

/// Adds the first problem of samples whose accelerations are over `gravity` [m/s^2], at `/excitation/file`.
void check_ground_motion(const std::vector<dynamics::GroundMotionSample>& samples, double gravity, Problems& problems);

}  // namespace rocking
