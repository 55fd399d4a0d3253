#include "rocking/output/text_table.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

constexpr std::size_t longest_cell = 40;
constexpr std::ptrdiff_t lines_of_a_screen = 55;

bool begins_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// With `...` in place of the middle if it is longer than a cell; the end, which tells files apart, keeps most.
std::string shortened(const std::string& cell) {
  const std::size_t letters = letters_in(cell);
  if (letters <= longest_cell) return cell;
  constexpr std::size_t kept_at_start = 12;
  constexpr std::size_t kept_at_end = longest_cell - kept_at_start - 3;
  std::string start, end;
  std::size_t letter = 0;
  for (const char byte : cell) {
    letter += begins_letter(byte) ? 1 : 0;
    if (letter <= kept_at_start) start += byte;
    if (letter > letters - kept_at_end) end += byte;
  }
  return start + "..." + end;
}

bool may_merge(const TextRow& a, const TextRow& b, std::size_t first, std::size_t count) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((i < first || i >= first + count) && a[i] != b[i]) return false;
  }
  return true;
}

// Neighbouring marks differ in brightness.
constexpr std::array<const char*, most_marks> unicode_marks{"█", "░", "▓", "▒", "▚", "·"};
constexpr std::array<const char*, most_marks> ascii_marks{"#", "-", "%", "=", "o", "."};

// One letter for each part with a count. The others go, one by one, to the part with the most realisations per letter.
std::vector<std::size_t> lengths_of(const std::vector<std::uint64_t>& counts, std::size_t length) {
  std::vector<std::size_t> lengths(counts.size());
  std::ranges::transform(counts, lengths.begin(), [](std::uint64_t count) { return count > 0 ? 1U : 0U; });
  for (std::size_t used = std::accumulate(lengths.begin(), lengths.end(), std::size_t{0}); used < length; ++used) {
    std::size_t shortest = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double a_letter =
          static_cast<double>(counts[i]) / static_cast<double>(std::max<std::size_t>(lengths[i], 1));
      if (a_letter <= most) continue;
      most = a_letter;
      shortest = i;
    }
    ++lengths[shortest];
  }
  return lengths;
}

}  // namespace

std::size_t letters_in(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_letter));
}

std::string aligned(const std::vector<TextRow>& given) {
  if (given.empty()) return {};
  std::vector<TextRow> rows = given;
  for (TextRow& row : rows) std::ranges::transform(row, row.begin(), shortened);
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

bool is_printed_whole(std::string_view text, Extent extent) {
  return extent == Extent::all || std::ranges::count(text, '\n') <= lines_of_a_screen;
}

std::vector<TextRow> merged_rows(const std::vector<TextRow>& table, std::size_t first, std::size_t count) {
  std::vector<TextRow> merged;
  for (std::size_t from = 0, to = 0; from < table.size(); from = ++to) {
    while (from > 0 && to + 1 < table.size() && may_merge(table[from], table[to + 1], first, count)) ++to;
    TextRow& row = merged.emplace_back(table[from]);
    for (std::size_t i = first; i < first + count && to > from; ++i) row[i] += " to " + table[to][i];
  }
  return merged;
}

std::string mark_of(std::size_t place, Letters letters) {
  return letters == Letters::unicode ? unicode_marks.at(place) : ascii_marks.at(place);
}

std::string share_bar(const std::vector<std::uint64_t>& counts, const BarLook& look) {
  ROCKING_EXPECT(counts.size() <= std::min(look.length, most_marks));
  ROCKING_EXPECT(std::ranges::any_of(counts, [](std::uint64_t count) { return count > 0; }));
  const std::vector<std::size_t> lengths = lengths_of(counts, look.length);
  std::string bar;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    for (std::size_t letter = 0; letter < lengths[i]; ++letter) bar += mark_of(i, look.letters);
  }
  return bar;
}

}  // namespace rocking
