#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "rocking/stats/fit_suite.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "support/split_mix.hpp"

namespace rocking::support {

/// Whether a trial has the same capacity at all levels, or one of its own at each.
enum class TrialCapacity : std::uint8_t { common, independent };

/// A suite of records whose law is known.
struct MadeUpSuite {
  std::size_t records = 20;
  std::vector<double> intensities = {0.6, 0.8, 1.0, 1.3, 1.7};
  std::size_t trials = 40;
  double median = 1.0;
  double between_records = 0.4;
  double within_record = 0.3;
  TrialCapacity capacity = TrialCapacity::independent;

  [[nodiscard]] stats::SuiteLevels drawn(SplitMix& random) const {
    const auto normal = [&random] {
      const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
      return radius * std::cos(2.0 * std::numbers::pi * random.uniform());
    };
    stats::SuiteLevels suite(records);
    for (auto& record : suite) {
      const double of_record = std::log(median) + between_records * normal();
      for (const double intensity : intensities) {
        record.push_back({.intensity = intensity, .happened = {.successes = 0, .trials = trials}});
      }
      for (std::size_t j = 0; j < trials; ++j) {
        double own = normal();
        for (stats::RecordLevel& level : record) {
          if (of_record + within_record * own < std::log(level.intensity)) ++level.happened.successes;
          if (capacity == TrialCapacity::independent) own = normal();
        }
      }
    }
    return suite;
  }
};

}  // namespace rocking::support

/// Six records with given outcomes, and a hazard.
namespace rocking::support::six_records {

inline constexpr double uplift = 0.2;
inline const std::vector<double> intensities{0.15, 0.3, 0.4, 0.6, 0.9};

/// H = 1e-4 x^-2.
inline double hazard_at(double x) { return 1e-4 / (x * x); }
inline const HazardCurve& hazard() {
  static const HazardCurve curve{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.1, 1e-2}, {0.25, 1.6e-3}, {2.0, 2.5e-5}}};
  return curve;
}

/// Numbers of 10 trials that overturn, of each record at each intensity; the third record falls at 0.6.
inline const std::vector<std::vector<int>> outcomes{{0, 0, 2, 7, 10}, {0, 1, 6, 10, 10}, {0, 4, 9, 6, 9},
                                                    {0, 0, 0, 3, 8},  {0, 2, 3, 8, 10},  {0, 0, 5, 9, 10}};

inline StripeGroup group_of(const std::vector<std::vector<int>>& counts) {
  StripeGroup group{.parameter = "/excitation/pga_g", .others = {}, .confidence = 0.95, .stripes = {}};
  for (std::size_t r = 0; r < counts.size(); ++r) {
    for (std::size_t k = 0; k < intensities.size(); ++k) {
      Stripe& stripe = group.stripes.emplace_back();
      stripe.record = "r" + std::to_string(r);
      stripe.intensity = intensities[k];
      for (int j = 0; j < 10; ++j) stripe.overturned.push_back(j < counts[r][k]);
      stripe.peaks.resize(10);
      stripe.uplift = uplift;
    }
  }
  return group;
}

inline const SuiteCurve& whole_curve() {
  static const SuiteCurve found = suite_curve(group_of(outcomes), {}, 1);
  return found;
}

inline double estimate(const SuiteRate& rate, RateSource source) {
  for (const RateEstimate& each : rate.estimates) {
    if (each.source == source) return each.value;
  }
  return NAN;
}

/// Integral of P |dH| from the least uplift on, by the midpoint rule in ln x.
inline double midpoint_rate(const std::function<double(double x)>& probability) {
  constexpr int steps = 200000;
  const double step = std::log(1e4 / uplift) / steps;
  double rate = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double low = uplift * std::exp(i * step), high = uplift * std::exp((i + 1) * step);
    rate += probability(std::sqrt(low * high)) * (hazard_at(low) - hazard_at(high));
  }
  return rate;
}

/// The shares of all records, or of one.
inline std::vector<double> shares_of(std::optional<std::size_t> record = std::nullopt) {
  std::vector<double> shares(intensities.size(), 0.0);
  for (std::size_t r = 0; r < outcomes.size(); ++r) {
    if (record && r != *record) continue;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      shares[k] += 0.1 * outcomes[r][k] / (record ? 1.0 : static_cast<double>(outcomes.size()));
    }
  }
  return shares;
}

/// From 0 at the least uplift, linear in ln x, then as at the last level.
inline double interpolated(const std::vector<double>& shares, double x) {
  if (x >= intensities.back()) return shares.back();
  std::size_t k = 1;
  while (intensities[k] < x) ++k;
  const double from = k == 1 ? uplift : intensities[k - 1];
  const double before = k == 1 ? 0.0 : shares[k - 1];
  return before + (shares[k] - before) * std::log(x / from) / std::log(intensities[k] / from);
}

/// Rare estimates at two levels, of each record; the level of ten events, 25 of 60, is 0.4.
inline const std::vector<double> rare_at{0.25, 0.3};
inline SuiteCurve with_rare(const std::vector<std::vector<double>>& of_records) {
  SuiteCurve found = whole_curve();
  for (std::size_t k = 0; k < rare_at.size(); ++k) {
    double mean = 0.0;
    for (std::size_t r = 0; r < of_records.size(); ++r) {
      const double probability = of_records[r][k];
      mean += probability / static_cast<double>(of_records.size());
      if (probability == 0.0) continue;
      found.records[r].curve.rare.push_back({.intensity = rare_at[k], .probability = probability});
    }
    found.rare.push_back({.intensity = rare_at[k], .probability = mean});
  }
  return found;
}
inline const std::vector<std::vector<double>> unlike{{0.0, 0.0},  {0.0, 1e-4},  {2e-4, 6e-3},
                                                     {0.0, 2e-5}, {1e-6, 4e-4}, {4e-5, 1e-3}};

}  // namespace rocking::support::six_records
