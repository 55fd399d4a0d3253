#include <algorithm>
#include <set>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/csv_table.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

/// Places of both measures and of the rate among the columns.
using Columns = std::array<std::size_t, 3>;

/// Of the header; absent, with a problem, where it does not name them.
std::optional<Columns> columns_of(const std::vector<std::string>& names, const std::vector<std::string>& measures,
                                  std::string_view line, LineProblems& problems) {
  const std::array<std::string_view, 3> wanted{measures.at(0), measures.at(1), "annual_rate"};
  Columns columns{};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto found = std::ranges::find(names, wanted[i]);
    if (found == names.end() || names.size() != wanted.size()) {
      problems.reject_line(line, "does not name the columns of the joint hazard",
                           "begin the file with: " + measures[0] + ',' + measures[1] + ",annual_rate");
      return std::nullopt;
    }
    columns[i] = static_cast<std::size_t>(found - names.begin());
  }
  return columns;
}

class JointHazardReader {
 public:
  JointHazardReader(std::string name, const std::vector<std::string>& measures)
      : lines_(name, problems_), measures_(measures), hazard_{.name = std::move(name), .cells = {}} {}

  JointHazard read(std::string_view text) {
    CsvTable rows(without_byte_order_mark(text), lines_, {.do_blanks_separate = true});
    if (rows.next()) columns_ = columns_of(rows.fields(), measures_, rows.line(), lines_);
    while (columns_ && rows.next()) add(rows.line(), rows.fields());
    const bool has_rate = std::ranges::any_of(hazard_.cells, [](const JointCell& cell) { return cell.rate > 0.0; });
    if (!lines_.any() && !has_rate) {
      lines_.reject_file("has no cell with a rate above 0",
                         "give lines of " + measures_[0] + ", " + measures_[1] + " and annual_rate");
    }
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
    return std::move(hazard_);
  }

 private:
  void add(std::string_view line, const std::vector<std::string>& fields) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto number = lines_.number(fields[(*columns_)[i]]);
      if (!number) return;
      values[i] = *number;
    }
    const JointCell cell{.x = values[0], .y = values[1], .rate = values[2]};
    if (!is_sensible(cell)) {
      return lines_.reject_line(line, "is no cell: measures must be positive, and rates not negative",
                                "give the middle of the cell, and the rate of occurrence in it");
    }
    if (!cells_.insert({cell.x, cell.y}).second) {
      return lines_.reject_line(line, "stands twice", "give each cell one line, with the sum of its rates");
    }
    hazard_.cells.push_back(cell);
  }

  Problems problems_;
  LineProblems lines_;
  const std::vector<std::string>& measures_;
  std::optional<Columns> columns_;
  std::set<std::pair<double, double>> cells_;
  JointHazard hazard_;
};

}  // namespace

JointHazard read_joint_hazard(std::string_view text, const std::string& name,
                              const std::vector<std::string>& measures) {
  if (measures.size() != 2) {
    throw base::InputError(
        {name, "", "is the hazard over the two measures of a surface, which are not given", "give a surface"});
  }
  return JointHazardReader(name, measures).read(text);
}

}  // namespace rocking
