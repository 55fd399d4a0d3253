#include "rocking/report/text_table.hpp"

#include <algorithm>
#include <charconv>

#include "rocking/base/error.hpp"

namespace rocking::report {
namespace {

std::string in_format(double number, std::chars_format format, int precision) {
  char text[400];  // 1.8e308 has 309 digits before the point
  const auto [end, error] = std::to_chars(text, text + sizeof text, number, format, precision);
  ROCKING_EXPECT(error == std::errc());
  static_cast<void>(error);
  return {text, end};
}

}  // namespace

std::size_t letters_in(std::string_view text) {
  const auto begins = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins));
}

std::string significant(double number, int digits) { return in_format(number, std::chars_format::general, digits); }

std::string fixed_point(double number, int decimals) { return in_format(number, std::chars_format::fixed, decimals); }

std::string per_cent(double probability, int decimals) { return fixed_point(100.0 * probability, decimals); }

std::string per_cent(const stats::Interval& interval, int decimals) {
  return '[' + per_cent(interval.low, decimals) + ", " + per_cent(interval.high, decimals) + ']';
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

std::string aligned(const std::vector<TextRow>& rows) {
  if (rows.empty()) return {};
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TextRow& row : rows) {
    ROCKING_EXPECT(row.size() == widths.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters_in(row[i]));
  }
  std::string text;
  for (const TextRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text.append(widths[i] - letters_in(row[i]) + (i == 0 ? 0 : 2), ' ');
      text += row[i];
    }
    text += '\n';
  }
  return text;
}

}  // namespace rocking::report
