#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rocking::stats {

/// Significance level of the test of a value p of a category's probability: the probability of rejecting p if it is the
/// true value, fixed + proportional p.
struct Significance {
  double fixed = 0.0;
  double proportional = 0.0;

  [[nodiscard]] constexpr double at(double p) const { return fixed + proportional * p; }
};

/// A family of categories; each trial falls into exactly one of them. Some categories are prespecified, that is, fixed
/// before there were data. There may be any number of others, which are unknown until they occur.
///
/// Statements about all categories hold at once with probability `confidence`, in (0, 1), if each uses its significance
/// level. A prespecified category receives the share 1/(prespecified + 1) of 1 - confidence. All others together
/// receive one such share, divided in proportion to their probabilities. These add up to 1 at most, however many
/// categories there are (Bonferroni's inequality with weights that depend on the tested value).
struct Family {
  std::size_t prespecified = 0;
  double confidence = 0.95;

  [[nodiscard]] constexpr double share() const { return (1.0 - confidence) / static_cast<double>(prespecified + 1); }
  [[nodiscard]] constexpr Significance of_prespecified() const { return {.fixed = share(), .proportional = 0.0}; }
  [[nodiscard]] constexpr Significance of_others() const { return {.fixed = 0.0, .proportional = share()}; }
};

/// How often each category of a family occurred in a number of trials.
struct CategoryCounts {
  std::uint64_t trials = 0;
  std::vector<std::uint64_t> prespecified;  ///< one count for each prespecified category, also if it is 0
  std::vector<std::uint64_t> others;        ///< counts of the others that occurred
};

/// Closed interval.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Number of successes out of a number of trials.
struct Proportion {
  std::uint64_t successes = 0;
  std::uint64_t trials = 0;
};

/// Two-sided confidence intervals for a probability; `confidence` in (0, 1). All lie in [0, 1] and contain
/// successes/trials. Without trials they are [0, 1].

/// Score interval: those p whose distance from the proportion is at most z sqrt(p (1 - p)/n).
///
/// Its coverage equals the confidence on average over p; for some p it is lower. Recommended for figures.
/// Source: Wilson (1927), J. Am. Stat. Assoc. 22, 209-212.
[[nodiscard]] Interval wilson(const Proportion& proportion, double confidence);

/// Exact interval: those p for which neither tail from the count outwards has a probability below (1 - confidence)/2.
///
///     P(K >= k | low) = (1 - confidence)/2 (low = 0 for k = 0),   P(K <= k | high) = the same (high = 1 for k = n)
///
/// Covers the true value at least as often as promised, for every p and n. Recommended for statements.
/// Source: Clopper & Pearson (1934), Biometrika 26, 404-413.
[[nodiscard]] Interval clopper_pearson(const Proportion& proportion, double confidence);

/// An interval for one probability that reports state.
struct IntervalMethod {
  std::string_view key;
  std::string_view sentence;
  Interval (*of)(const Proportion& proportion, double confidence);
};
inline constexpr auto interval_methods =
    std::to_array<IntervalMethod>({{"wilson", "interval for this mode alone: Wilson's", wilson},
                                   {"clopper_pearson", "interval for this mode alone, exact", clopper_pearson}});

/// In the order of the methods.
using IntervalsByMethod = std::array<Interval, interval_methods.size()>;

/// As clopper_pearson, with a significance level that may depend on p: those p for which neither tail has a probability
/// below significance(p)/2. Each p is missed with probability at most significance(p). Requires significance(1) < 1.
///
/// There is one crossing on each side: the upper tail is convex, then concave in p, and ends above the straight line of
/// the significance level. If that level is proportional to p, one success out of any number of trials gives low = 0:
/// among many rare categories some are expected to occur.
[[nodiscard]] Interval exact_interval(const Proportion& proportion, const Significance& significance);

/// The exact interval at level 1 - (1 - confidence)/categories, for one of `categories` >= 1 categories fixed before
/// there were data. All of these intervals cover at once with probability at least `confidence` (Bonferroni's
/// inequality).
[[nodiscard]] Interval bonferroni_clopper_pearson(const Proportion& proportion, double confidence,
                                                  std::size_t categories);

}  // namespace rocking::stats
