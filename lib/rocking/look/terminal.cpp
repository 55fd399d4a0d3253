#include <algorithm>

#include "rocking/look/table.hpp"
#include "rocking/look/text_table.hpp"

namespace rocking::look {
namespace {

constexpr std::size_t longest_cell = 40;

/// With `...` in place of the middle if it is longer than a cell; the end, which tells files apart, keeps most.
std::string shortened(const std::string& cell) {
  const std::size_t letters = letters_in(cell);
  if (letters <= longest_cell) return cell;
  constexpr std::size_t kept_at_start = 12;
  constexpr std::size_t kept_at_end = longest_cell - kept_at_start - 3;
  std::string start, end;
  std::size_t letter = 0;
  for (const char byte : cell) {
    letter += letters_in({&byte, 1});
    if (letter <= kept_at_start) start += byte;
    if (letter > letters - kept_at_end) end += byte;
  }
  return start + "..." + end;
}

std::string lines_of(const Table& all) {
  const Table table = part_in(Media::terminal, all);
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : table.columns) lines.front().push_back(shortened(column.title));
  for (const Row& row : table.rows) {
    std::vector<std::string>& line = lines.emplace_back();
    for (const Cell& cell : row) line.push_back(shortened(plain_text(cell, table.absent)));
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], letters_in(line[i]));
  }
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text.append(widths[i] - letters_in(line[i]) + (i == 0 ? 0 : 2), ' ');
      text += line[i];
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string to_terminal(const Table& table) {
  return table.title + (table.title.empty() ? "" : "\n") + lines_of(table) + table.notes;
}

std::size_t width_of(const Table& table) {
  const std::string lines = lines_of(table);
  return letters_in(lines.substr(0, lines.find('\n')));
}

}  // namespace rocking::look
