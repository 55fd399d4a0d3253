#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rocking/look/table.hpp"
#include "rocking/output/report.hpp"

/// Tables of a run whose rows are conditions.
namespace rocking {

/// A column with the cell of each condition.
struct ConditionColumn {
  look::Column column;
  std::function<look::Cell(const ReportedCondition&)> cell;
};
using ConditionColumns = std::vector<ConditionColumn>;

/// What tells the conditions apart, in short for readers: the swept parameters; in `other_forms` both forms of the
/// shaking and the factor on a ground motion, where they differ and are not swept. CSV has all digits, and the shaking
/// also where it does not differ. The number of realisations is shown in `n`.
[[nodiscard]] ConditionColumns condition_columns(const Report& report,
                                                 look::Media other_forms = look::Media::publications,
                                                 look::Media n = look::Media::csv);

/// A row for each condition, or for those that `is_shown` selects.
[[nodiscard]] look::Table table_of(const Report& report, const ConditionColumns& columns,
                                   const std::function<bool(const ReportedCondition&)>& is_shown = {});

/// A table of a run for readers and for other programs.
struct RunTable {
  std::string name;     ///< of its files
  std::string caption;  ///< in plain text, without a point at its end; empty: it is not for readers
  look::Table table;    ///< without rows: it is not shown
  look::Media media = look::Media::all;
};

/// A table that may have several rows for a condition.
class ConditionTable {
 public:
  /// It begins with condition_columns().
  ConditionTable(const Report& report, const std::vector<look::Column>& further);
  [[nodiscard]] const look::Table& table() const { return table_; }
  [[nodiscard]] look::Row row(const ReportedCondition& condition, const look::Row& further) const;
  void add(const ReportedCondition& condition, const look::Row& further);

 private:
  ConditionColumns start_;
  look::Table table_;
};

}  // namespace rocking
