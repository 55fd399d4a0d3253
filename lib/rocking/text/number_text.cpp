#include "rocking/text/number_text.hpp"

#include <charconv>

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

}  // namespace rocking
