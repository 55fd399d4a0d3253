#pragma once

#include <string>

#include "rocking/look/text_table.hpp"
#include "rocking/studies/fragility/suite_curve.hpp"

namespace rocking {

/// Whether a table lists each record.
enum class RecordTable : std::uint8_t { omitted, shown };

/// The curve of a suite as text; on one screen of the measures of intensity only the most efficient.
[[nodiscard]] std::string suite_table(const SuiteCurve& curve, RecordTable records, Extent extent);

/// An incremental dynamic analysis as text.
[[nodiscard]] std::string incremental_table(const IncrementalAnalysis& analysis);

}  // namespace rocking
