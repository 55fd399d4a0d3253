#pragma once

#include <string>
#include <string_view>

#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/cost/cost.hpp"

namespace rocking {

inline constexpr std::string_view cost_format = "rocking.cost/1";

/// The cost of accuracy in an experiment, and the system on which it was measured.
struct MeasuredCost {
  const Experiment* experiment;
  Cost cost;
  SystemFacts system;
};

/// `rocking.cost/1` (lib/docs/formats.md). All but `system` has the same bytes for equal experiment, tolerances and
/// sample.
[[nodiscard]] std::string cost_text(const MeasuredCost& measured);

}  // namespace rocking
