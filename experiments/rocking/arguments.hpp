#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>

namespace rocking::program {

/// Lets whole numbers from `low` to `high` pass, written as digits.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

/// Lets numbers from `low` to `high` pass.
[[nodiscard]] CLI::Validator number(double low, double high);

/// Lets times such as 90s, 15min, 2h, 1d pass, longer than nothing, and hands them on in seconds.
[[nodiscard]] CLI::Validator duration();

/// The seconds of such a time; without a unit it is in seconds. Absent where it is none.
[[nodiscard]] std::optional<double> seconds_in(std::string_view text);

}  // namespace rocking::program
