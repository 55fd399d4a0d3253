#include "rocking/ensemble/mode_family.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace rocking {
namespace {

using section::ResponseKind;

constexpr std::array prespecified_modes{section::periodic(1, 1),
                                        section::periodic(1, 3),
                                        section::ResponseMode{.kind = ResponseKind::chaotic},
                                        section::ResponseMode{.kind = ResponseKind::overturned},
                                        section::ResponseMode{.kind = ResponseKind::rest},
                                        section::ResponseMode{.kind = ResponseKind::unresolved}};

/// So many of them, from the first on, are listed in a report also where they did not occur.
constexpr std::size_t first_listed = 4;

}  // namespace

std::vector<section::ResponseMode> most_frequent(const ModeTally& tally, std::size_t most) {
  std::vector<std::pair<section::ResponseMode, std::uint64_t>> ranked(tally.begin(), tally.end());
  std::ranges::stable_sort(ranked, std::greater{}, [](const auto& entry) { return entry.second; });
  if (ranked.size() > most) ranked.resize(most);
  std::vector<section::ResponseMode> modes;
  for (const auto& [mode, count] : ranked) modes.push_back(mode);
  std::ranges::sort(modes);
  return modes;
}

std::span<const section::ResponseMode> always_listed() { return std::span(prespecified_modes).first<first_listed>(); }

bool is_prespecified(const section::ResponseMode& mode) {
  return std::find(prespecified_modes.begin(), prespecified_modes.end(), mode) != prespecified_modes.end();
}

stats::Family mode_family(double confidence) {
  return {.prespecified = prespecified_modes.size(), .confidence = confidence};
}

stats::Significance significance_of(const section::ResponseMode& mode, double confidence) {
  const stats::Family family = mode_family(confidence);
  return is_prespecified(mode) ? family.of_prespecified() : family.of_others();
}

stats::Interval simultaneous_interval(const section::ResponseMode& mode, const stats::Proportion& counts,
                                      double confidence) {
  return stats::exact_interval(counts, significance_of(mode, confidence));
}

stats::CategoryCounts category_counts(const ModeTally& tally) {
  stats::CategoryCounts counts;
  for (const section::ResponseMode& mode : prespecified_modes) {
    const auto found = tally.find(mode);
    counts.prespecified.push_back(found == tally.end() ? 0 : found->second);
  }
  for (const auto& [mode, count] : tally) {
    counts.trials += count;
    if (!is_prespecified(mode)) counts.others.push_back(count);
  }
  return counts;
}

}  // namespace rocking
