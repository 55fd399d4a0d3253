#include "realisation_list.hpp"

#include <fmt/format.h>

namespace rocking::program {
namespace {

constexpr std::size_t most_ranges = 12;

/// Consecutive realisations of a condition.
struct Range {
  RealisationKey first;
  std::uint64_t count = 1;
};

std::vector<Range> ranges_of(const std::vector<RealisationKey>& keys) {
  std::vector<Range> ranges;
  for (const auto& key : keys) {
    const bool follows = !ranges.empty() && ranges.back().first.condition == key.condition &&
                         ranges.back().first.realisation + ranges.back().count == key.realisation;
    if (follows) {
      ++ranges.back().count;
    } else {
      ranges.push_back({key});
    }
  }
  return ranges;
}

}  // namespace

std::string listed_realisations(const std::vector<RealisationKey>& keys) {
  if (keys.empty()) return "none";
  std::string text;
  std::uint64_t listed = 0;
  std::uint64_t condition = 0;
  const std::vector<Range> ranges = ranges_of(keys);
  for (std::size_t i = 0; i < ranges.size() && i < most_ranges; ++i) {
    const auto& [first, count] = ranges[i];
    if (i == 0 || first.condition != condition) {
      text += fmt::format("{}condition {}: realisations ", i == 0 ? "" : "; ", first.condition);
    } else {
      text += ", ";
    }
    condition = first.condition;
    text += count == 1 ? fmt::format("{}", first.realisation)
                       : fmt::format("{}-{}", first.realisation, first.realisation + count - 1);
    listed += count;
  }
  return listed == keys.size() ? text : fmt::format("{}, and {} more", text, keys.size() - listed);
}

}  // namespace rocking::program
