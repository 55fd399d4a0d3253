#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/line_problems.hpp"
#include "rocking/scene/ground_motion_reading.hpp"

namespace rocking {

/// What stands above the numbers of a file of columns: lines of text and comments. They do not decide what a column is,
/// but must not contradict what was taken for it.
class LinesAboveColumns {
 public:
  /// `line`: as it stands in the file; `text`: the same without its comment.
  void add(std::string_view line, std::string_view text);

  /// The unit of accelerations that the last line of text states: absent if it states none, or several.
  [[nodiscard]] std::optional<RecordUnit> stated_unit() const { return stated_; }

  /// Reports a unit above the numbers other than that which was asked for or is assumed, a line that speaks of velocities or
  /// displacements in place of accelerations, and a name above a column that is not what `columns` calls it.
  void check(const std::vector<RecordColumn>& columns, std::optional<RecordUnit> asked, LineProblems& problems) const;

 private:
  std::string heads_;                   ///< the last line of text
  std::optional<RecordUnit> stated_;    ///< there
  std::string_view other_motion_;       ///< there: `velocity` or `displacement` in place of accelerations
  std::optional<RecordUnit> remarked_;  ///< in a comment
};

}  // namespace rocking
