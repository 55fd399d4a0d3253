#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/random/draws.hpp"
#include "rocking/stats/suite_bootstrap.hpp"
#include "rocking/studies/curves/fragility_curve.hpp"

namespace rocking::support {

/// The curve of a suite without a law: all that its rate by shares needs, in a small part of the time.
inline SuiteCurve suite_by_shares(const stats::SuiteLevels& suite, std::optional<double> least_uplift,
                                  std::uint64_t seed, std::uint64_t samples) {
  SuiteCurve curve;
  curve.subject.confidence = 0.95;
  curve.subject.least_uplift = least_uplift;
  curve.outcome = stats::FragilityOutcome::does_not_rise;
  for (const stats::RecordLevel& level : suite.front()) curve.levels.push_back({.intensity = level.intensity});
  for (std::size_t r = 0; r < suite.size(); ++r) {
    RecordCurve& record = curve.records.emplace_back();
    record.name = "r" + std::to_string(r);
    for (const stats::RecordLevel& level : suite[r]) {
      record.curve.levels.push_back({.intensity = level.intensity, .overturned = level.happened});
    }
  }
  const auto draws = [seed](std::uint64_t sample, std::uint64_t number) {
    return random::Draws(seed, sample).uniform(random::Source::fragility_bootstrap, number);
  };
  curve.bootstrap.samples = samples;
  for (std::uint64_t sample = 0; sample < samples; ++sample) {
    curve.bootstrap.with_unseen.push_back(stats::shares_with_unseen(suite.size(), sample, draws));
  }
  return curve;
}

}  // namespace rocking::support
