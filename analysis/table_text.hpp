#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/look/table.hpp"
#include "rocking/output/report.hpp"

/// Pieces of tables in CSV and LaTeX.
namespace rocking::analysis {

/// The first columns of a CSV: the swept parameters; both forms of the shaking without those that are swept, whether they
/// differ between conditions or not; n.
class CsvStart {
 public:
  explicit CsvStart(const Report& report);

  /// A table that begins with them.
  [[nodiscard]] look::Table table(const std::vector<look::Column>& further) const;
  [[nodiscard]] look::Row row(const ReportedCondition& condition, const look::Row& further) const;

 private:
  std::vector<std::string_view> shaking_;
  look::Table table_;
};

/// A number for CSV; nothing if there is none.
[[nodiscard]] look::Cell exact(const std::optional<double>& number,
                               const std::optional<look::Ends>& interval = std::nullopt);

/// A table for readers that begins with these columns.
[[nodiscard]] look::Table table_of(const std::vector<ParameterColumn>& parameters,
                                   const std::vector<std::string>& further);
/// Its row of a condition.
[[nodiscard]] look::Row row_of(const std::vector<ParameterColumn>& parameters, std::size_t condition,
                               const look::Row& further = {});

/// In LaTeX, with the title of the run before the caption.
[[nodiscard]] std::string latex_of(const look::Table& table, const Report& report, const std::string& caption);

/// The symbol of a parameter in mathematics mode, or its name.
[[nodiscard]] std::string latex_symbol(const std::string& pointer);

}  // namespace rocking::analysis
