#pragma once

#include <string>
#include <string_view>

#include "rocking/experiment/cost.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/report/write_report.hpp"

namespace rocking::report {

inline constexpr std::string_view cost_format = "rocking.cost/1";

/// What accuracy costs in an experiment, and where that was measured.
struct MeasuredCost {
  const experiment::Experiment* experiment;
  experiment::Cost cost;
  SystemFacts system;
};

/// `rocking.cost/1` (lib/docs/formats.md). All but `system` are the same bytes for equal experiment, tolerances and sample.
[[nodiscard]] std::string cost_text(const MeasuredCost& measured);

/// The same for reading: a row for each tolerance, one for each number of realisations, and what is recommended.
[[nodiscard]] std::string cost_table(const MeasuredCost& measured);

/// What is recommended and why, in words and numbers: one paragraph.
[[nodiscard]] std::string cost_recommendation(const MeasuredCost& measured);

}  // namespace rocking::report
