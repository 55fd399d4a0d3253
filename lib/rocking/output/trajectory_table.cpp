#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/output/trajectory_report.hpp"

namespace rocking {
namespace {

struct Row {
  double time;
  int order;  ///< among rows of one time
  std::string text;
};

Row row_of(int order, const std::string& name, double time, const ReportedState& state, const std::string& end) {
  std::string text = name;
  for (const double number : {time, state.tilt, state.tilt_rate, state.slip, state.slip_rate}) {
    text += ',' + base::shortest(number);
  }
  return {.time = time, .order = order, .text = text + ',' + end};
}

std::vector<Row> rows_of(const TrajectoryReport& report) {
  std::vector<Row> rows;
  for (const auto& [time, kind, state] : report.events) {
    rows.push_back(row_of(0, "event", time, state, ',' + std::string(to_string(kind))));
  }
  for (const auto& [period, time, state, contact] : report.strobe) {
    rows.push_back(row_of(1, "strobe", time, state, std::string(to_string(contact)) + ','));
  }
  for (const auto& [time, state, contact] : report.history) {
    rows.push_back(row_of(2, "sample", time, state, std::string(to_string(contact)) + ','));
  }
  std::ranges::stable_sort(rows, {}, [](const Row& row) { return std::tuple(row.time, row.order); });
  return rows;
}

}  // namespace

std::string trajectory_table(const TrajectoryReport& report) {
  std::string text = "# format: " + std::string(trajectory_document().format());
  text += "\n# condition: " + std::to_string(report.key.condition);
  text += "\n# realisation: " + std::to_string(report.key.realisation);
  text += "\n# units: " + std::string(trajectory_unit_names[static_cast<std::size_t>(report.units)]);
  const Json block = block_fields().json(&report.block);
  for (const auto& [name, value] : block.items()) text += "\n# " + name + ": " + value.dump();
  text += "\n# termination: " + std::string(to_string(report.termination));
  text += report.units == TrajectoryUnits::si ? "\nrow,time_s,tilt_rad,tilt_rate_rad_s,slip_m,slip_rate_m_s"
                                              : "\nrow,tau,tilt,tilt_rate,slip,slip_rate";
  text += ",contact,event\n";
  for (const Row& row : rows_of(report)) text += row.text + '\n';
  return text;
}

}  // namespace rocking
