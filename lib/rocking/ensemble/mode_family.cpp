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

/// A response mode, or a part of one, of a list in which each realisation counts once.
struct Category {
  section::ResponseMode mode;
  std::uint64_t count = 0;
  stats::Significance significance;
};

/// The probability of each, in their order.
std::vector<Estimate> estimates_of(const std::vector<Category>& categories, double confidence,
                                   std::uint64_t without_answer) {
  std::uint64_t trials = 0;
  for (const Category& each : categories) trials += each.count;
  std::vector<Estimate> estimates;
  for (const auto& [mode, count, significance] : categories) {
    Estimate estimate;
    estimate.counts = {.successes = count, .trials = trials};
    estimate.estimate = static_cast<double>(count) / static_cast<double>(trials);
    const auto covering = [bounds = bounds_of(mode, estimate.counts, without_answer)](auto&& interval_of) {
      return stats::covering(bounds, interval_of);
    };
    std::ranges::transform(stats::interval_methods, estimate.alone.begin(), [&](const stats::IntervalMethod& method) {
      return covering([&](const stats::Proportion& each) { return method.of(each, confidence); });
    });
    estimate.simultaneous =
        covering([&level = significance](const stats::Proportion& each) { return stats::exact_interval(each, level); });
    estimates.push_back(estimate);
  }
  return estimates;
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
  std::vector<Category> categories;
  for (const auto& [mode, count] : listed) {
    categories.push_back({.mode = mode, .count = count, .significance = significance_of(mode, confidence)});
  }
  const std::vector<Estimate> estimates = estimates_of(categories, confidence, without_answer);
  std::vector<ModeEstimate> modes;
  for (const Category& each : categories) modes.push_back({.mode = each.mode, .probability = estimates[modes.size()]});
  return modes;
}

stats::Significance significance_of_side(double confidence) {
  const auto [fixed, proportional] = significance_of(overturned, confidence);
  return {.fixed = 0.5 * fixed, .proportional = 0.5 * proportional};
}

std::array<SideEstimate, 2> estimate_sides(const ModeTally& listed, const SideCounts& sides, double confidence,
                                           std::uint64_t without_answer) {
  std::vector<Category> categories;
  for (const std::uint64_t count : sides) {
    categories.push_back({.mode = overturned, .count = count, .significance = significance_of_side(confidence)});
  }
  for (const auto& [mode, count] : listed) {
    if (mode == overturned) continue;
    categories.push_back({.mode = mode, .count = count, .significance = significance_of(mode, confidence)});
  }
  const std::vector<Estimate> estimates = estimates_of(categories, confidence, without_answer);
  return {SideEstimate{estimates[0]}, SideEstimate{estimates[1]}};
}

}  // namespace rocking
