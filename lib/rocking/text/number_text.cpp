#include "rocking/text/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "rocking/base/error.hpp"

namespace rocking {

std::string fixed_point(double number, int decimals) {
  char text[400];  // 1.8e308 has 309 digits before the point
  const auto [end, error] = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, decimals);
  ROCKING_EXPECT(error == std::errc());
  static_cast<void>(error);
  return {text, end};
}

std::string per_cent(double probability, int decimals) { return fixed_point(100.0 * probability, decimals); }

std::string per_cent(const stats::Interval& interval, int decimals) {
  return '[' + per_cent(interval.low, decimals) + ", " + per_cent(interval.high, decimals) + ']';
}

std::string upper_bound_text(double probability) {
  constexpr double least_in_tenths = 0.001;
  return probability < least_in_tenths ? significant(100.0 * probability, 2) : per_cent(probability);
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

std::string spoken_size(std::uint64_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 1e6) return significant(size / 1e3, 3) + " kB";
  return size < 1e9 ? significant(size / 1e6, 3) + " MB" : significant(size / 1e9, 3) + " GB";
}

std::string spoken_duration(double seconds) {
  if (seconds < 9.95) return fixed_point(seconds, 1) + " s";
  const auto whole = static_cast<std::int64_t>(std::llround(std::min(seconds, 1e15)));
  const auto two_digits = [](std::int64_t number) { return (number < 10 ? "0" : "") + std::to_string(number); };
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + two_digits(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + two_digits(whole % 3600 / 60) + " min";
}

}  // namespace rocking
