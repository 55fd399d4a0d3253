#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>

#include "rocking/base/error.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking::program {

/// Accepts whole numbers from `low` to `high`, written as digits.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);

/// Accepts numbers from `low` to `high`.
[[nodiscard]] CLI::Validator number(double low, double high);

/// Accepts positive times such as 90s, 15min, 2h, 1d, and converts them to seconds.
[[nodiscard]] CLI::Validator duration();

/// The seconds of such a time; a number without a unit is in seconds. Absent if the text is not a time.
[[nodiscard]] std::optional<double> seconds_in(std::string_view text);

/// Adds `--shard i/n`.
void add_shard(CLI::App& command, std::optional<Shard>& shard);

/// The same error with flags in the places of the library's arguments, for example `--from` for `from`.
[[nodiscard]] base::InputError with_flags(const base::InputError& error,
                                          const std::map<std::string_view, std::string_view>& flags);

}  // namespace rocking::program
