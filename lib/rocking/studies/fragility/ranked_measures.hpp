#pragma once

#include <optional>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/studies/fragility/suite_curve.hpp"

namespace rocking {

/// Levels of each record. `measure`: in place of the swept intensity.
[[nodiscard]] stats::SuiteLevels levels_of_records(const std::vector<Stripe>& stripes, const FragilityEvent& event,
                                                   std::optional<IntensityMeasure> measure = std::nullopt);

/// The measures by growing dispersion of the law of the suite; of equal ones the one with the smaller deviance first.
/// Without measures: empty. `metadata`: of every record of the stripes, or empty. A measure is a part.
[[nodiscard]] std::vector<RankedMeasure> ranked_measures(const std::vector<Stripe>& stripes,
                                                         const FragilityEvent& event,
                                                         const std::vector<RecordMetadata>& metadata = {},
                                                         const base::ManyParts& how = {});

/// The metadata of the records of a suite, in their order. Throws base::InputError where a record has none or several.
[[nodiscard]] std::vector<RecordMetadata> metadata_of(const std::vector<std::string>& records,
                                                      const std::vector<RecordMetadata>& metadata);

}  // namespace rocking
