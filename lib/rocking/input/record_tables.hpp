#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"

/// Tables that select records: PEER's `_SearchResults.csv`, and the records and factors of each level.
namespace rocking {

/// A line of such a table.
struct SelectedRecord {
  std::string file;                                  ///< as the table names it
  std::optional<std::string> component = {};         ///< of a file that holds several
  std::optional<double> factor = std::nullopt;       ///< on its accelerations
  std::optional<double> level = std::nullopt;        ///< of intensity
  bool is_return_period = false;                     ///< of the level, which is in years
  std::optional<double> magnitude = std::nullopt;    ///< of its earthquake
  std::optional<double> distance_km = std::nullopt;  ///< from its station to the rupture
};

/// Whether a text has the line of PEER's metadata.
[[nodiscard]] bool is_search_results(std::string_view text);

/// The horizontal records of PEER's table, two for each line: between its line of metadata and the first empty one. A number
/// that is empty, `-` or -999 is not known; dashes stand for a component that does not exist. `name`: of the file, for problems.
[[nodiscard]] std::vector<SelectedRecord> search_results(std::string_view text, const std::string& name,
                                                         Problems& found);

/// Lines `level,file,factor`, or with `return_period_years` in place of `level`, perhaps with `component`, below a line with
/// these names in any order.
[[nodiscard]] std::vector<SelectedRecord> level_table(std::string_view text, const std::string& name, Problems& found);

}  // namespace rocking
