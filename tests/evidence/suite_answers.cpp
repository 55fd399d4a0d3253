// How often the test of a suite's law rejects, and how often the intervals of its annual rates cover the truth: the tables
// of reports/evidence/intervals.md.
//
//     suite_answers [simulated suites] [number of the first scenario]

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "support/split_mix.hpp"

namespace {

using rocking::support::SplitMix;

/// Capacities of the trials of a record are its own number times a lognormal one; the numbers of records come from a law
/// that need not be lognormal.
struct Scenario {
  std::string name;
  std::size_t records = 20;
  std::size_t trials = 25;
  double within_record = 0.1;
  std::function<double(SplitMix&)> of_record = nullptr;  ///< ln capacity of a record
  double stands_again = 0.0;                             ///< chance of a record to stand at a level above its capacity
  std::vector<double> levels = {0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.8};
};

/// Lognormal around 0.42.
double lognormal(SplitMix& random) { return std::log(0.42) + 0.35 * random.normal(); }
/// 0.22 at least, as for a block that needs so much to be lifted: the rest is lognormal.
double with_threshold(SplitMix& random) { return std::log(0.22 + 0.2 * std::exp(0.7 * random.normal())); }
/// Weak and strong records.
double two_kinds(SplitMix& random) { return std::log(random.uniform() < 0.5 ? 0.28 : 0.62) + 0.06 * random.normal(); }

std::vector<rocking::Stripe> drawn(const Scenario& scenario, SplitMix& random) {
  std::vector<rocking::Stripe> stripes;
  for (std::size_t r = 0; r < scenario.records; ++r) {
    const double own = scenario.of_record(random);
    std::vector<double> trials;
    for (std::size_t j = 0; j < scenario.trials; ++j) trials.push_back(own + scenario.within_record * random.normal());
    for (const double level : scenario.levels) {
      rocking::Stripe& stripe = stripes.emplace_back();
      stripe.record = "r" + std::to_string(r);
      stripe.intensity = level;
      stripe.uplift = 0.21;
      const bool stands = random.uniform() < scenario.stands_again;
      for (const double capacity : trials) stripe.overturned.push_back(!stands && capacity < std::log(level));
      stripe.peaks.resize(trials.size());
    }
  }
  return stripes;
}

rocking::HazardCurve hazard() {
  return {.name = "", .intensity = "pga_g", .header_line = 1, .points = {{0.05, 6.74e-2}, {2.0, 6.66e-6}}};
}

/// The rate of the scenario, by many records with one trial each.
double true_rate(const Scenario& scenario) {
  SplitMix random(99);
  const auto curve = hazard();
  const double exponent = std::log(curve.points[0].rate / curve.points[1].rate) /
                          std::log(curve.points[1].intensity / curve.points[0].intensity);
  double sum = 0.0;
  constexpr int count = 400000;
  for (int i = 0; i < count; ++i) {
    const double capacity = std::exp(scenario.of_record(random) + scenario.within_record * random.normal());
    sum += curve.points[0].rate * std::pow(std::max(capacity, 0.21) / 0.05, -exponent);
  }
  return sum / count;
}

struct Found {
  bool is_tested = false, is_rejected = false;
  std::array<double, 2> values{};  ///< by the law, by isotonic shares
  std::array<bool, 2> covers{};
  bool chosen_covers = false;
  double disagreement = 0.0, undecided = 0.0;
};

void measure(const Scenario& scenario, std::size_t suites) {
  const double truth = scenario.stands_again > 0.0 ? 0.0 : true_rate(scenario);
  std::vector<Found> found(suites);
  rocking::base::for_each_part({.threads = std::thread::hardware_concurrency()}, suites, [&](std::size_t i) {
    SplitMix random(2026 + 7919 * i);
    const rocking::StripeGroup group{
        .parameter = "/excitation/pga_g", .others = {}, .confidence = 0.95, .stripes = drawn(scenario, random)};
    const rocking::SuiteCurve curve = suite_curve(group, {}, i);
    found[i].is_tested = curve.test.has_value();
    found[i].is_rejected = curve.outcome == rocking::stats::FragilityOutcome::rejected;
    const rocking::SuiteRate rate = annual_rate(curve, hazard());
    const auto holds = [truth](const std::optional<rocking::stats::Interval>& interval) {
      return interval && interval->low <= truth && truth <= interval->high;
    };
    for (const auto& estimate : rate.estimates) {
      const std::size_t k = estimate.source == rocking::RateSource::law ? 0 : 1;
      found[i].values[k] = estimate.value;
      found[i].covers[k] = holds(estimate.interval);
    }
    found[i].chosen_covers = holds(rate.chosen.interval);
    found[i].disagreement = rate.disagreement.value_or(9.0);
    found[i].undecided = rate.undecided_share;
  });
  double tested = 0.0, rejected = 0.0, chosen = 0.0, agree = 0.0, undecided = 0.0;
  std::array<double, 2> mean{}, covered{};
  for (const Found& each : found) {
    tested += each.is_tested ? 1.0 : 0.0;
    rejected += each.is_rejected ? 1.0 : 0.0;
    chosen += each.chosen_covers ? 1.0 : 0.0;
    agree += each.disagreement <= rocking::most_disagreement ? 1.0 : 0.0;
    undecided += each.undecided;
    for (std::size_t k = 0; k < mean.size(); ++k) {
      mean[k] += each.values[k] / static_cast<double>(suites);
      covered[k] += each.covers[k] ? 1.0 : 0.0;
    }
  }
  const double per_cent = 100.0 / static_cast<double>(suites);
  std::printf("| %s | %.0f | %.1f |", scenario.name.c_str(), tested, 100.0 * rejected / std::max(1.0, tested));
  if (truth > 0.0) {
    for (const double value : mean) std::printf(" %.2f |", value / truth);
    for (const double count : covered) std::printf(" %.1f |", per_cent * count);
    std::printf(" %.1f | %.0f | %.1f |", per_cent * chosen, per_cent * agree, per_cent * undecided);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int arguments, char** values) {
  const auto suites = static_cast<std::size_t>(arguments > 1 ? std::atoi(values[1]) : 500);
  const auto first = static_cast<std::size_t>(arguments > 2 ? std::atoi(values[2]) : 0);
  const std::vector<Scenario> scenarios{
      {.name = "20 lognormal records", .of_record = lognormal},
      {.name = "20, 0.3 within one", .within_record = 0.3, .of_record = lognormal},
      {.name = "10 lognormal records", .records = 10, .of_record = lognormal},
      {.name = "40 lognormal records", .records = 40, .of_record = lognormal},
      {.name = "20, each stands again at a level with chance 0.2", .of_record = lognormal, .stands_again = 0.2},
      {.name = "20, threshold at 0.22", .of_record = with_threshold},
      {.name = "40, threshold at 0.22", .records = 40, .of_record = with_threshold},
      {.name = "20, weak and strong records", .of_record = two_kinds},
      {.name = "40, weak and strong records", .records = 40, .of_record = two_kinds}};
  for (std::size_t i = first; i < scenarios.size(); ++i) measure(scenarios[i], suites);
}
