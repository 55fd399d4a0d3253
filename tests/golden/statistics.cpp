// Prints the statistics that a report computes from counts, for a grid of counts: tests/golden/everywhere --statistics.

#include <cstdint>
#include <cstdio>

#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"

namespace {

using namespace rocking::stats;

void print(const Interval& interval) { std::printf("%.17g\n%.17g\n", interval.low, interval.high); }

}  // namespace

int main() {
  for (const std::uint64_t n : {1U, 2U, 7U, 50U, 200U, 1000U, 20000U, 1000000U}) {
    for (const std::uint64_t parts : {0U, 1U, 3U, 10U, 37U, 50U, 99U, 100U}) {
      const Proportion counts{.successes = n * parts / 100, .trials = n};
      for (const double confidence : {0.9, 0.95, 0.999}) {
        print(wilson(counts, confidence));
        print(clopper_pearson(counts, confidence));
        const PairedCounts paired{.both = counts.successes / 2,
                                  .first_only = counts.successes - counts.successes / 2,
                                  .second_only = (n - counts.successes) / 3,
                                  .neither = n - counts.successes - (n - counts.successes) / 3};
        print(paired_difference_score(paired, confidence));
        print(paired_difference_exact(paired, confidence));
        std::printf("%.17g\n%.17g\n", mcnemar(paired).p_value, mcnemar(paired).mid_p);
      }
    }
  }
}
