#pragma once

#include <string>

#include "rocking/studies/suite/incremental.hpp"
#include "rocking/studies/suite/suite_curve.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Whether a table lists each record.
enum class RecordTable : std::uint8_t { omitted, shown };

/// What the curve of a suite has in `rocking.fragility/1` beside title, digest and annual rate. `record`: the keys of
/// the curve of one record.
[[nodiscard]] Json suite_json(const SuiteCurve& curve, Json (*record)(const FragilityCurve&));

/// The curve of a suite as text.
[[nodiscard]] std::string suite_table(const SuiteCurve& curve, RecordTable records);

/// An incremental dynamic analysis in `rocking.fragility/1`, and as text.
[[nodiscard]] Json incremental_json(const IncrementalAnalysis& analysis);
[[nodiscard]] std::string incremental_table(const IncrementalAnalysis& analysis);

}  // namespace rocking
