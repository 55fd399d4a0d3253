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

}  // namespace

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
