#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/line_problems.hpp"
#include "rocking/scene/ground_motion_reading.hpp"

namespace rocking {

/// What stands beside the numbers of a file of columns: lines of text above them, and comments anywhere. They do not decide
/// what a column is, but must not contradict what was taken for it; the units that they state are read.
class LinesAboveColumns {
 public:
  /// `text`: the whole file.
  void read(std::string_view text);

  /// Takes the names above the columns into account, which are `columns`. Reports names that are not those, what is no
  /// motion, a unit other than that which was asked for, and one that is not known or not clear.
  void check(const std::vector<RecordColumn>& columns, std::optional<RecordUnit> asked, LineProblems& problems);

  /// The unit of accelerations that the last line of text states, or else the others and comments. After check().
  [[nodiscard]] std::optional<RecordUnit> stated_unit() const;
  /// That a unit which is stated cannot be read, beside the one that was asked for; empty: none is. After check().
  [[nodiscard]] const std::string& warning() const { return warning_; }
  /// How many units of its times a second holds: 1000 where these are in ms. After check().
  [[nodiscard]] double times_per_second() const { return times_per_second_; }
  /// The component that a line names, by the code of its sensor or beside the word `component`; empty: none.
  [[nodiscard]] const std::string& component() const { return component_; }

 private:
  /// The units that lines state.
  struct Statement {
    std::vector<RecordUnit> units;  ///< different ones
    std::string unclear;            ///< a unit that is not known, or has a factor
    [[nodiscard]] bool is_empty() const { return units.empty() && unclear.empty(); }
  };
  void take_text(std::string_view words);
  static void add_units(std::string_view line, bool is_head, Statement& statement);
  void take_head(std::string_view head, RecordColumn column, LineProblems& problems);
  void check_unit(std::optional<RecordUnit> asked, LineProblems& problems);
  [[nodiscard]] const Statement& statement() const { return of_heads_.is_empty() ? of_remarks_ : of_heads_; }

  std::string heads_;              ///< the last line of text, or the last comment above the numbers
  bool are_heads_text_ = false;    ///< a line of text, no comment
  std::string remarks_;            ///< all other lines and comments
  std::string_view other_motion_;  ///< in a line of text: `velocity` or `displacement` in place of accelerations
  Statement of_heads_, of_remarks_;
  std::string component_, warning_;
  double times_per_second_ = 1.0;
};

}  // namespace rocking
