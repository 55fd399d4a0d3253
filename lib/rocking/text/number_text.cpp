#include "rocking/text/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

/// Digits after the point that leave two significant digits of a number; 0 of 0.
int decimals_for_two_digits(double number) {
  constexpr double rounding = 1e-6;  // 0.0999999 has the digits of 0.1, as which it is written
  if (number == 0.0) return 0;
  return std::max(0, 1 - static_cast<int>(std::floor(std::log10((1.0 + rounding) * std::abs(number)))));
}

}  // namespace

std::string fixed_point(double number, int decimals) {
  char text[400];  // 1.8e308 has 309 digits before the point
  const auto [end, error] = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, decimals);
  ROCKING_EXPECT(error == std::errc());
  static_cast<void>(error);
  return {text, end};
}

std::string per_cent(double probability, int least_decimals) {
  constexpr double least_in_full = 1e-6;  // per cent; below, leading zeros are harder to read than an exponent
  constexpr double rounding = 1e-12;      // of sums of probabilities
  const double number = 100.0 * probability;
  const double complement = 1.0 - probability;
  if (number != 0.0 && std::abs(number) < least_in_full) return significant(number, 2);
  int decimals = std::max(least_decimals, decimals_for_two_digits(number));
  if (std::abs(complement) > rounding) decimals = std::max(decimals, decimals_for_two_digits(100.0 * complement));
  return fixed_point(number, decimals);
}

std::string per_cent(const stats::Interval& interval, int least_decimals) {
  return '[' + per_cent(interval.low, least_decimals) + ", " + per_cent(interval.high, least_decimals) + ']';
}

std::string per_cent_of(std::uint64_t count, std::uint64_t all) {
  return per_cent(static_cast<double>(count) / static_cast<double>(all));
}

std::string rate_text(double rate) {
  constexpr int least_exponent = -2;  // below, leading zeros are harder to read
  if (rate == 0.0 || !std::isfinite(rate)) return significant(rate, 2);
  char text[16];  // -5.0e-308
  const std::to_chars_result written = std::to_chars(text, text + sizeof text, rate, std::chars_format::scientific, 1);
  ROCKING_EXPECT(written.ec == std::errc());
  const char* const e = std::find(static_cast<const char*>(text), static_cast<const char*>(written.ptr), 'e');
  const int exponent = std::stoi(std::string(e + 1, static_cast<const char*>(written.ptr)));
  if (exponent < least_exponent) return std::string(static_cast<const char*>(text), e) + 'e' + std::to_string(exponent);
  return fixed_point(rate, std::max(0, 1 - exponent));
}

std::string count_if_open(std::uint64_t count, std::uint64_t all) {
  constexpr std::uint64_t most_told_by_tenths = 1000;
  return count == 0 || all <= most_told_by_tenths ? "" : " (" + std::to_string(count) + ')';
}

std::string count_legend(std::uint64_t most) {
  return count_if_open(most, most).empty() ? "" : "; (k): k realisations";
}

std::string counted(std::uint64_t number, std::string_view noun) {
  return std::to_string(number) + ' ' + std::string(noun) + (number == 1 ? "" : "s");
}

std::string level_text(double confidence) {
  constexpr int most_digits = 17;
  std::string text;
  for (int digits = 6; digits <= most_digits; ++digits) {
    text = significant(100.0 * confidence, digits);
    if (text != "100") break;
  }
  return text;
}

std::string size_in_words(std::uint64_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 1e6) return significant(size / 1e3, 3) + " kB";
  return size < 1e9 ? significant(size / 1e6, 3) + " MB" : significant(size / 1e9, 3) + " GB";
}

std::string duration_in_words(double seconds) {
  if (seconds < 9.95) return fixed_point(seconds, 1) + " s";
  const auto whole = static_cast<std::int64_t>(std::llround(std::min(seconds, 1e15)));
  const auto two_digits = [](std::int64_t number) { return (number < 10 ? "0" : "") + std::to_string(number); };
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + two_digits(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + two_digits(whole % 3600 / 60) + " min";
}

std::string interval_in_words(const stats::Interval& interval) {
  return '[' + significant(interval.low, 3) + ", " +
         (std::isfinite(interval.high) ? significant(interval.high, 3) : "unbounded") + ']';
}

std::optional<std::uint64_t> seed_from_text(std::string_view text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  std::uint64_t seed = 0;
  const char* const all_read = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), all_read, seed, hexadecimal ? 16 : 10);
  if (error != std::errc() || end != all_read) return std::nullopt;
  return seed;
}

std::string seed_text(std::uint64_t seed) {
  char digits[16];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, seed, 16);
  static_cast<void>(error);  // 16 digits hold every 64-bit number
  return "0x" + std::string(digits, end);
}

}  // namespace rocking
