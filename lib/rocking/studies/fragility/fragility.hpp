#pragma once

#include <variant>

#include "rocking/base/many_parts.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/studies/curves/curves.hpp"
#include "rocking/studies/fragility/question.hpp"

namespace rocking {

/// The surface over two different measures, of surface_measure_names, with the bootstrap samples of the records that the
/// curve of the same group has. Throws base::InputError if a measure is not known of a motion.
[[nodiscard]] FragilitySurface fragility_surface(const StripeGroup& group, const SuiteCurve& curve,
                                                 const std::vector<std::string>& measures,
                                                 const std::optional<JointHazard>& hazard = std::nullopt,
                                                 const base::ManyParts& how = {});

/// The curves of a run from its stripes: for each group, for each event. Throws base::InputError if the hazard curve is one
/// of another intensity, and base::Stopped if
/// it is asked to stop. Uses `threads`, `stop_requested` and `on_progress` of
/// the options; progress counts parts of about equal work, most of them bootstrap samples.
[[nodiscard]] RunFragility run_fragility(const Experiment& experiment, const std::vector<StripeGroup>& groups,
                                         const FragilityQuestion& question, const RunOptions& options);

/// The probabilities of an event with this rate within each of these times.
[[nodiscard]] std::vector<RateInYears> in_years(const AnnualRate& rate, const std::vector<double>& years);

/// A block of a run: its curve of the event, and the stripes from which it follows.
struct BlockCurve {
  std::string name;
  std::variant<const FragilityCurve*, const SuiteCurve*> curve;
  const StripeGroup* group;
};

/// Whether the blocks still stand after `years` [years], > 0, under each of the hazard curves, at least one. Several blocks
/// must have the same levels of the same motions. `seed`: of the bootstraps of all together. Throws base::InputError.
[[nodiscard]] Survival survival(const std::vector<BlockCurve>& blocks, double years,
                                const std::vector<HazardCurve>& hazards, std::uint64_t seed,
                                const base::ManyParts& how = {});

}  // namespace rocking
