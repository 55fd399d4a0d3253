#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/hazard.hpp"

namespace rocking {

inline constexpr std::size_t most_metadata_bytes = 10'000'000;

/// Reads what is known of the earthquakes of records: lines of values between commas, of which the first names the columns:
/// `file`, and `magnitude`, `distance_km`, or both, in any order, a number that is not known being empty;
/// `#` begins a comment. Or PEER's `_SearchResults.csv` (record_tables.hpp). `name`: of the file, for messages.
///
/// Throws base::InputError with line, value and remedy of every fault: another or a doubled column, a line with too few or
/// too many values, a value that is no number, a magnitude that
/// is not from 0 to 10, a distance that is not positive, a record that stands twice.
[[nodiscard]] std::vector<RecordMetadata> read_record_metadata(std::string_view text, const std::string& name);

}  // namespace rocking
