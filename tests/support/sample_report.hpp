#pragma once

#include <cstdint>
#include <map>

#include "rocking/base/digest.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/report.hpp"
#include "rocking/text/json.hpp"

namespace rocking::support {

/// An invented estimate whose numbers all differ.
inline Estimate sample_estimate(std::uint64_t count, std::uint64_t n) {
  const double p = static_cast<double>(count) / static_cast<double>(n);
  const stats::Interval interval{.low = 0.9 * p, .high = 0.1 + 0.9 * p};
  return {.counts = {count, n},
          .estimate = p,
          .alone = {interval, interval},
          .simultaneous = {.low = 0.8 * p, .high = 0.2 + 0.8 * p}};
}

/// An invented report of a grid of two frictions and three amplitudes: (1,1) is replaced by (1,3), some realisations
/// overturn.
inline Json sample_report() {
  const auto experiment = experiment_in(R"({
    "format": "rocking.experiment/1", "title": "made up", "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0 },
    "friction": { "static": 0.35, "kinetic": 0.30 }, "fluctuation": { "friction": { "sigma": 0.03 } },
    "sweep": [ { "parameter": "/friction",
                 "values": [ { "static": 0.35, "kinetic": 0.30 }, { "static": 0.40, "kinetic": 0.35 } ] },
               { "parameter": "/excitation/amplitude", "values": [3.0, 4.0, 5.5] } ],
    "realisations": 30 })");
  ExperimentResult result{.conditions = {}, .digest = base::sha256("made up")};
  for (std::uint64_t i = 0; i < experiment.conditions.size(); ++i) {
    ConditionResult condition;
    condition.realisations = 30;
    const std::map<section::ResponseMode, std::uint64_t> counts{{section::periodic(1, 1), 30 - 5 * i},
                                                                {section::periodic(1, 3), 4 * i},
                                                                {{section::ResponseKind::chaotic}, 0},
                                                                {{section::ResponseKind::overturned}, i}};
    for (const auto& [mode, count] : counts) condition.modes.push_back({mode, sample_estimate(count, 30)});
    auto& difference = condition.non_recurrence.emplace();
    difference.differ = 0.1 * static_cast<double>(i);
    difference.differ_interval = {.low = 0.05 * static_cast<double>(i), .high = 0.2 + 0.1 * static_cast<double>(i)};
    difference.entropy = 0.2 * static_cast<double>(i);
    difference.arithmetic_tolerance = 1e-15;
    difference.friction = {
        .pairs = 15, .diverged = 2 * i, .lower_quartile = 12.5, .median = 80.0, .upper_quartile = {}};
    result.conditions.push_back(std::move(condition));
  }
  SystemFacts facts;
  facts.start = "2012-02-01T12:00:00Z";
  return Json::parse(report_text(experiment, result, facts));
}

}  // namespace rocking::support
