#include "arguments.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace rocking::program {
namespace {

/// The value if the entire text is one; absent otherwise.
template <class Number>
std::optional<Number> read_whole(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

std::optional<double> seconds_of_unit(const std::string& unit) {
  constexpr std::array<std::pair<std::string_view, double>, 5> units{
      {{"", 1.0}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}}};
  for (const auto& [name, seconds] : units) {
    if (name == unit) return seconds;
  }
  return std::nullopt;
}

/// `2/5` as a shard.
Shard shard_from(const std::string& text) {
  constexpr std::uint64_t most_parts = 999'999'999;
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto part = read_whole<std::uint64_t>(std::string_view(text).substr(0, slash));
    const auto parts = read_whole<std::uint64_t>(std::string_view(text).substr(slash + 1));
    if (part && parts && 1 <= *part && *part <= *parts && *parts <= most_parts) return {.part = *part, .parts = *parts};
  }
  throw CLI::ValidationError(
      "--shard", fmt::format("{} is not a part of a whole; give i/n with 1 <= i <= n, for example 2/5", text));
}

}  // namespace

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const auto check = [low, high](const std::string& written) -> std::string {
    const auto value = read_whole<std::uint64_t>(written);
    if (value && low <= *value && *value <= high) return "";
    return fmt::format("\"{}\" is not a whole number from {} to {}; give a value such as {}", written, low, high, low);
  };
  return {check, "", "whole number"};
}

CLI::Validator number(double low, double high) {
  const auto check = [low, high](const std::string& written) -> std::string {
    const auto value = read_whole<double>(written);
    if (value && low <= *value && *value <= high) return "";
    return fmt::format("\"{}\" is not a number from {:g} to {:g}", written, low, high);
  };
  return {check, "", "number"};
}

CLI::Validator duration() {
  const auto transform = [](std::string& written) -> std::string {
    const auto seconds = seconds_in(written);
    if (!seconds) {
      return fmt::format("\"{}\" is not a positive duration; give one such as 90s, 15min, 2h or 1d", written);
    }
    written = fmt::format("{}", *seconds);
    return "";
  };
  CLI::Validator validator;
  validator.name("duration").operation(transform);
  return validator;
}

std::optional<double> seconds_in(std::string_view text) {
  const std::string_view all = trimmed(text);
  const std::size_t digits = std::min(all.find_first_not_of("0123456789."), all.size());
  const auto number = read_whole<double>(all.substr(0, digits));
  const auto unit = seconds_of_unit(CLI::detail::to_lower(std::string(trimmed(all.substr(digits)))));
  if (!number || !unit) return std::nullopt;
  const double seconds = *number * *unit;
  return seconds > 0.0 && std::isfinite(seconds) ? std::optional<double>(seconds) : std::nullopt;
}

void add_shard(CLI::App& command, std::optional<Shard>& shard) {
  const auto set = [&shard](const std::string& text) { shard = shard_from(text); };
  command.add_option_function<std::string>("--shard", set, "Run only the i-th of n parts; `rocking merge` joins them")
      ->type_name("I/N");
}

base::InputError with_flags(const base::InputError& error, const std::map<std::string_view, std::string_view>& flags) {
  base::Problem problem = error.problems().front();
  if (const auto flag = flags.find(problem.place); flag != flags.end()) problem.place = flag->second;
  return base::InputError(problem);
}

}  // namespace rocking::program
