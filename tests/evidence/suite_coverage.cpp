// How often the intervals of a suite's law cover the truth: the table of reports/evidence/intervals.md.
//
//     suite_coverage [simulated suites] [bootstrap samples]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "rocking/stats/fit_suite.hpp"
#include "support/made_up_suite.hpp"

namespace {

using rocking::stats::Interval;
using rocking::stats::SuiteQuantity;
using rocking::support::MadeUpSuite;
using rocking::support::TrialCapacity;

constexpr std::array quantities{SuiteQuantity::median, SuiteQuantity::dispersion, SuiteQuantity::between_records,
                                SuiteQuantity::within_record};

struct Scenario {
  std::string name;
  MadeUpSuite suite;
};

std::vector<Scenario> scenarios() {
  const auto common = TrialCapacity::common;
  return {{"20 records, independent trials", {}},
          {"20 records, common capacity of a trial", {.capacity = common}},
          {"8 records, common", {.records = 8, .capacity = common}},
          {"20 records, little between them, common", {.between_records = 0.1, .capacity = common}},
          {"20 records, little within one, common", {.within_record = 0.05, .capacity = common}},
          {"20 records, 1 trial", {.trials = 1, .capacity = common}}};
}

bool covers(const std::optional<Interval>& interval, double truth) {
  return interval && interval->low <= truth && truth <= interval->high;
}

void measure(const Scenario& scenario, int suites, std::uint64_t samples) {
  rocking::support::SplitMix random(2015);
  rocking::stats::SuiteLaw truth{.median = scenario.suite.median,
                                 .between_records = scenario.suite.between_records,
                                 .within_record = scenario.suite.within_record,
                                 .log_likelihood = 0.0};
  int fitted = 0;
  std::array<int, 4> by_profile{}, by_bootstrap{};
  for (int i = 0; i < suites; ++i) {
    const auto suite = scenario.suite.drawn(random);
    const auto law = rocking::stats::fit_suite(suite).law;
    if (!law) continue;
    ++fitted;
    const auto draws = [&](std::uint64_t sample, std::uint64_t number) {
      return rocking::support::SplitMix((static_cast<std::uint64_t>(i) << 32U) + 1000 * sample + number).uniform();
    };
    const auto bootstrap = rocking::stats::bootstrap_records(suite, samples, draws);
    for (std::size_t k = 0; k < quantities.size(); ++k) {
      const double value = value_of(quantities[k], truth);
      by_profile[k] += covers(profile_interval(suite, *law, quantities[k], 0.95), value) ? 1 : 0;
      std::vector<double> values;
      for (const auto& sample : bootstrap.laws) values.push_back(value_of(quantities[k], sample));
      by_bootstrap[k] += covers(rocking::stats::percentile_interval(values, samples, 0.95), value) ? 1 : 0;
    }
  }
  std::printf("| %s | %d |", scenario.name.c_str(), fitted);
  for (const auto& counts : {by_profile, by_bootstrap}) {
    for (const int count : counts) std::printf(" %.1f |", 100.0 * count / fitted);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int arguments, char** values) {
  const int suites = arguments > 1 ? std::atoi(values[1]) : 1000;
  const auto samples = static_cast<std::uint64_t>(arguments > 2 ? std::atoi(values[2]) : 199);
  for (const Scenario& scenario : scenarios()) measure(scenario, suites, samples);
}
