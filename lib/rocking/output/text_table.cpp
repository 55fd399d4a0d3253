#include "rocking/output/text_table.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking {

std::size_t letters_in(std::string_view text) {
  const auto begins = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins));
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

}  // namespace rocking
