#include "rocking/ensemble/mode_family.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "rocking/stats/interval.hpp"

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

constexpr section::ResponseMode overturned{.kind = ResponseKind::overturned};

/// A response mode, or a part of one.
struct Category {
  section::ResponseMode mode;
  std::uint64_t count = 0;
  stats::Significance significance;
};

std::uint64_t trials_of(const ModeTally& listed) {
  std::uint64_t trials = 0;
  for (const auto& [mode, count] : listed) trials += count;
  return trials;
}

Estimate estimate_of(const Category& category, std::uint64_t trials, double confidence, std::uint64_t without_answer) {
  Estimate estimate;
  estimate.counts = {.successes = category.count, .trials = trials};
  estimate.estimate = static_cast<double>(category.count) / static_cast<double>(trials);
  const auto covering = [bounds = bounds_of(category.mode, estimate.counts, without_answer)](auto&& interval_of) {
    return stats::covering(bounds, interval_of);
  };
  std::ranges::transform(stats::interval_methods, estimate.alone.begin(), [&](const stats::IntervalMethod& method) {
    return covering([&](const stats::Proportion& each) { return method.of(each, confidence); });
  });
  estimate.simultaneous =
      covering([&](const stats::Proportion& each) { return stats::exact_interval(each, category.significance); });
  return estimate;
}

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

stats::CountBounds bounds_of(const section::ResponseMode& mode, const stats::Proportion& counted,
                             std::uint64_t without_answer) {
  if (mode != section::ResponseMode{}) return stats::bounds_of(counted, without_answer);
  return {.least = {.successes = counted.successes - without_answer, .trials = counted.trials}, .most = counted};
}

std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence, std::uint64_t without_answer) {
  const std::uint64_t trials = trials_of(listed);
  std::vector<ModeEstimate> modes;
  for (const auto& [mode, count] : listed) {
    const Category category{.mode = mode, .count = count, .significance = significance_of(mode, confidence)};
    modes.push_back({.mode = mode, .probability = estimate_of(category, trials, confidence, without_answer)});
  }
  return modes;
}

stats::Significance significance_of_side(double confidence) {
  const auto [fixed, proportional] = significance_of(overturned, confidence);
  return {.fixed = 0.5 * fixed, .proportional = 0.5 * proportional};
}

std::array<SideEstimate, 2> estimate_sides(const ModeTally& listed, const SideCounts& sides, double confidence,
                                           std::uint64_t without_answer) {
  const auto estimate = [&, trials = trials_of(listed)](std::uint64_t count) {
    const Category side{.mode = overturned, .count = count, .significance = significance_of_side(confidence)};
    return SideEstimate{estimate_of(side, trials, confidence, without_answer)};
  };
  return {estimate(sides[0]), estimate(sides[1])};
}

}  // namespace rocking
