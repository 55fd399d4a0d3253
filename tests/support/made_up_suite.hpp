#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "rocking/stats/fit_suite.hpp"
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
