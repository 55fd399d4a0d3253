#pragma once

#include <cstdint>

#include "rocking/experiment/experiment.hpp"
#include "rocking/report/object_reader.hpp"

namespace rocking::report {

/// Whether the options of the formulation are written out: not where a sweep changes the formulation, for an option that
/// is written out overrides it.
enum class OptionSpelling : std::uint8_t { all, as_written };

/// The keys `block`, `formulation`, `slide_inertia`, `restitution`, `impact_slip_rule`, `excitation`, `friction`,
/// `fluctuation` and `initial`, each value by itself. What values demand of each other: check_scene.
[[nodiscard]] experiment::Scene read_scene(ObjectReader& in, OptionSpelling options);

/// The key `fluctuation`; `scene` already holds the means.
void read_fluctuation(ObjectReader& in, experiment::Scene& scene);

}  // namespace rocking::report
