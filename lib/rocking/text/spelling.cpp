#include "rocking/text/spelling.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rocking {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table of distances between the first i letters of a and the first j of b.
  std::vector<std::size_t> before_previous(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
  std::iota(previous.begin(), previous.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replaced, previous[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before_previous[j - 2] + 1);
      }
    }
    std::swap(before_previous, previous);
    std::swap(previous, current);
  }
  return previous[b.size()];
}

std::optional<std::string> nearest_word(std::string_view written, std::span<const std::string> words) {
  constexpr std::size_t longest = 100;  // no word of ours is that long, and the distance takes time
  if (written.size() > longest) return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t least = 0;
  for (const std::string& word : words) {
    const std::size_t distance = edit_distance(written, word);
    if (!nearest || distance < least) {
      nearest = word;
      least = distance;
    }
  }
  // `width` for `width_m` is near too: the unit was forgotten.
  if (nearest && !(nearest->starts_with(written) && !written.empty()) &&
      3 * least > std::max<std::size_t>(3, nearest->size())) {
    return std::nullopt;
  }
  return nearest;
}

}  // namespace rocking
