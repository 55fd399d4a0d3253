// How often the interval of the rate of a suite by isotonic shares covers the truth: the table "Rates by shares" of
// reports/evidence/intervals.md. Records are lognormal, and a realisation has one capacity at all levels of a record, as
// in the program.
//
//     suite_rates [simulated suites]

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "rocking/studies/curves/hazard_integral.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "support/made_up_suite.hpp"
#include "support/suite_by_shares.hpp"

namespace {

using rocking::support::MadeUpSuite;

constexpr double uplift = 0.125;

rocking::HazardCurve hazard() {
  return {.name = "", .intensity = "", .header_line = 0, .points = {{0.05, 6.74e-2}, {2.0, 6.66e-6}}};
}

struct Found {
  int covered = 0, above = 0;  ///< the truth lies above the interval
  double estimate = 0.0, low = 0.0, high = 0.0;
};

/// Of ln low and ln high the means, over the truth.
Found measured(const MadeUpSuite& suite, int suites) {
  const rocking::LognormalCapacity capacity{.centre = std::log(suite.median),
                                            .dispersion = std::hypot(suite.between_records, suite.within_record)};
  const double truth = rate_of(capacity, rocking::pieces_between(hazard(), uplift));
  Found found;
  for (int i = 0; i < suites; ++i) {
    rocking::support::SplitMix random(2026 + 7919 * static_cast<std::uint64_t>(i));
    const auto curve =
        rocking::support::suite_by_shares(suite.drawn(random), uplift, static_cast<std::uint64_t>(i), 499);
    const rocking::AnnualRate rate = annual_rate(curve, hazard()).chosen;
    found.covered += rate.interval->low <= truth && truth <= rate.interval->high ? 1 : 0;
    found.above += truth > rate.interval->high ? 1 : 0;
    found.estimate += rate.value / truth / suites;
    found.low += rate.interval->low / truth / suites;
    found.high += std::log(rate.interval->high / truth) / suites;
  }
  return found;
}

}  // namespace

int main(int arguments, char** values) {
  const int suites = arguments > 1 ? std::atoi(values[1]) : 400;
  std::vector<double> dense;
  for (double level = 0.22; level < 1.3; level *= 1.1) dense.push_back(level);
  const std::vector<std::pair<std::string, std::vector<double>>> levels{
      {"7, 0.25 to 0.8", {0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.8}},
      {"3, 0.25 to 1", {0.25, 0.5, 1.0}},
      {"19, 0.22 to 1.2", dense}};
  for (const auto& [name, intensities] : levels) {
    for (const double median : {0.2, 0.42, 0.8, 1.5}) {
      for (const std::size_t records : {5U, 10U, 20U, 30U, 40U}) {
        std::printf("| %s | %.2f | %zu |", name.c_str(), median, records);
        for (const auto& [between, within] : {std::pair{0.35, 0.1}, {0.15, 0.3}, {0.35, 0.3}, {0.6, 0.1}}) {
          const Found found = measured({.records = records,
                                        .intensities = intensities,
                                        .trials = 25,
                                        .median = median,
                                        .between_records = between,
                                        .within_record = within,
                                        .capacity = rocking::support::TrialCapacity::common},
                                       suites);
          std::printf(" %.1f (%.2f [%.2f, %.1f]) |", 100.0 * found.covered / suites, found.estimate, found.low,
                      std::exp(found.high));
        }
        std::printf("\n");
        std::fflush(stdout);
      }
    }
  }
}
