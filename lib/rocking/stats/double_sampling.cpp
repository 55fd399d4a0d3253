#include "rocking/stats/paired.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

double fraction(std::uint64_t part, std::uint64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double corrected_estimate(const CheckedCounts& counts) {
  ROCKING_EXPECT(counts.classified.trials > 0 && counts.checked > 0);
  const double estimate = fraction(counts.classified.successes, counts.classified.trials) +
                          fraction(counts.gained, counts.checked) - fraction(counts.lost, counts.checked);
  return std::clamp(estimate, 0.0, 1.0);
}

Interval corrected_interval(const CheckedCounts& counts, double confidence) {
  const double significance = 1.0 - confidence;
  const Interval classified = clopper_pearson(counts.classified, 1.0 - significance / 2.0);
  const Interval gained = clopper_pearson({counts.gained, counts.checked}, 1.0 - significance / 4.0);
  const Interval lost = clopper_pearson({counts.lost, counts.checked}, 1.0 - significance / 4.0);
  return {std::max(0.0, classified.low + gained.low - lost.high),
          std::min(1.0, classified.high + gained.high - lost.low)};
}

}  // namespace rocking::stats
