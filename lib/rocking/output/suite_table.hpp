#pragma once

#include <string>

#include "rocking/studies/suite/suite_curve.hpp"

namespace rocking {

/// Whether a table lists each record.
enum class RecordTable : std::uint8_t { omitted, shown };

/// The curve of a suite as text.
[[nodiscard]] std::string suite_table(const SuiteCurve& curve, RecordTable records);

/// An incremental dynamic analysis as text.
[[nodiscard]] std::string incremental_table(const IncrementalAnalysis& analysis);

}  // namespace rocking
