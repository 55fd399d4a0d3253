#include "rocking/look/text_table.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

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

std::string wrapped_line(std::string_view line, std::size_t width) {
  const std::size_t indented = std::min(line.find_first_not_of(' '), line.size());
  const std::string indentation(line.substr(0, indented));
  std::string_view rest = line.substr(indented);
  if (letters_in(line) <= width || rest.find("  ") != rest.npos) return std::string(line);
  std::string text = indentation;
  std::size_t letters = indented;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    const bool is_first = letters == indented;
    if (!is_first && letters + 1 + letters_in(word) > width) {
      text += '\n' + indentation;
      letters = indented;
    } else if (!is_first) {
      text += ' ';
      ++letters;
    }
    text += word;
    letters += letters_in(word);
  }
  return text;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
  std::string all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    all += wrapped_line(text.substr(0, end), width);
    if (end < text.size()) all += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

std::size_t letters_in(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

bool is_printed_whole(std::string_view text, Extent extent) {
  constexpr std::ptrdiff_t lines_of_a_screen = 55;
  return extent == Extent::all || std::ranges::count(text, '\n') <= lines_of_a_screen;
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
