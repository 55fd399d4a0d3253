#include "rocking/output/write_trajectory.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// A written quantity: its name, with its unit if it has one, and its value over the normalised one.
struct Column {
  const char* name;
  double scale = 1.0;

  [[nodiscard]] double of(double normalised) const { return normalised * scale; }
};

/// The quantities of a trajectory in some units.
struct Columns {
  Column tilt{"tilt"};
  Column tilt_rate{"tilt_rate"};
  Column slip{"slip"};
  Column slip_rate{"slip_rate"};
  const char* time = "tau";
  const char* first_loss = "first_loss_of_contact";
  double frequency_parameter = 1.0;  ///< tau over the written time

  [[nodiscard]] double time_of(double tau) const { return tau / frequency_parameter; }
};

Columns columns_of(const Trajectory& trajectory, TrajectoryUnits units) {
  if (units == TrajectoryUnits::normalised) return {};
  const dynamics::Geometry block = dynamics::geometry_of(trajectory.block);
  const double psi = block.shape_angle;
  const double p = block.frequency_parameter;
  return {.tilt = {"tilt_rad", psi},
          .tilt_rate = {"tilt_rate_rad_s", psi * p},
          .slip = {"slip_m", block.half_diagonal},
          .slip_rate = {"slip_rate_m_s", block.half_diagonal * p},
          .time = "time_s",
          .first_loss = "first_loss_of_contact_s",
          .frequency_parameter = p};
}

/// A trajectory with the units in which it is written.
struct Written {
  const Trajectory* trajectory;
  Columns columns;
  TrajectoryUnits units;
};

/// Adds tilt and slip with their rates.
template <class Sample>
void add_state(Json& line, const Sample& sample, const Columns& columns) {
  line[columns.tilt.name] = columns.tilt.of(sample.tilt);
  line[columns.tilt_rate.name] = columns.tilt_rate.of(sample.tilt_rate);
  line[columns.slip.name] = columns.slip.of(sample.slip);
  line[columns.slip_rate.name] = columns.slip_rate.of(sample.slip_rate);
}

Json line_of(const TrajectorySample& sample, const Written& written) {
  Json line = Json::object();
  line["period"] = sample.period;
  if (written.units == TrajectoryUnits::si) {
    const double tau = static_cast<double>(sample.period) * written.trajectory->period_length;
    line[written.columns.time] = written.columns.time_of(tau);
  }
  add_state(line, sample, written.columns);
  line["contact"] = to_string(sample.contact);
  return line;
}

Json line_of(const TrajectoryEvent& event, const Written& written) {
  Json line = Json::object();
  line[written.columns.time] = written.columns.time_of(event.tau);
  line["kind"] = to_string(event.kind);
  add_state(line, event, written.columns);
  return line;
}

Json line_of(const HistorySample& sample, const Written& written) {
  Json line = Json::object();
  line[written.columns.time] = written.columns.time_of(sample.tau);
  add_state(line, sample, written.columns);
  line["contact"] = to_string(sample.contact);
  return line;
}

Json json_of(const dynamics::Block& block) {
  const dynamics::Geometry geometry = dynamics::geometry_of(block);
  Json json = Json::object();
  json["width_m"] = block.width;
  json["height_m"] = block.height;
  json["gravity_m_s2"] = block.gravity;
  json["shape_angle_rad"] = geometry.shape_angle;
  json["half_diagonal_m"] = geometry.half_diagonal;
  json["frequency_parameter_rad_s"] = geometry.frequency_parameter;
  return json;
}

Json validity_of(const Written& written) {
  const Trajectory& trajectory = *written.trajectory;
  Json validity = Json::object();
  validity["losses_of_contact"] = trajectory.losses_of_contact;
  Json& first = validity[written.columns.first_loss] = nullptr;
  if (trajectory.first_loss_of_contact) first = written.columns.time_of(*trajectory.first_loss_of_contact);
  validity["losses_before_fall"] = trajectory.losses_before_fall;
  validity["contradictions"] = trajectory.contradictions;
  return validity;
}

Json peaks_of(const Written& written) {
  const PeakValues& peaks = written.trajectory->peaks;
  const Columns& columns = written.columns;
  Json json = Json::object();
  json[columns.tilt.name] = columns.tilt.of(peaks.tilt);
  json[columns.tilt_rate.name] = columns.tilt_rate.of(peaks.tilt_rate);
  json["slip"] = peaks.slip;
  json["slip_m"] = peaks.slip_m;
  json["final_slip"] = peaks.final_slip;
  json["final_slip_m"] = peaks.final_slip_m;
  return json;
}

Json account_of(const EnergyAccount& energy) {
  Json account = Json::object();
  account["at_start"] = energy.at_start;
  account["at_end"] = energy.at_end;
  account["base_work"] = energy.base_work;
  account["friction_work"] = energy.friction_work;
  account["lost_in_impacts"] = energy.lost_in_impacts;
  account["gained_in_impacts"] = energy.gained_in_impacts;
  account["unaccounted"] = energy.unaccounted();
  return account;
}

// A JSON list with a line for each entry, so that thousands of entries remain readable, also for tools that read lines.
template <class Entries>
std::string list_of(const Entries& entries, const Written& written) {
  std::string text = "[";
  for (const auto& entry : entries) {
    if (text.size() > 1) text += ',';
    text += "\n    " + line_of(entry, written).dump();
  }
  return text + (entries.empty() ? "]" : "\n  ]");
}

/// A row of the table; its time is tau.
struct CsvRow {
  double tau;
  int order;  ///< among rows of one time
  std::string text;
};

template <class Sample>
std::string state_cells(double tau, const Sample& sample, const Columns& columns) {
  std::string text;
  for (const double number :
       {columns.time_of(tau), columns.tilt.of(sample.tilt), columns.tilt_rate.of(sample.tilt_rate),
        columns.slip.of(sample.slip), columns.slip_rate.of(sample.slip_rate)}) {
    text += base::shortest(number) + ',';
  }
  return text;
}

std::vector<CsvRow> rows_of(const Written& written) {
  const Trajectory& trajectory = *written.trajectory;
  const Columns& columns = written.columns;
  std::vector<CsvRow> rows;
  for (const TrajectoryEvent& event : trajectory.events) {
    rows.push_back(
        {.tau = event.tau,
         .order = 0,
         .text = "event," + state_cells(event.tau, event, columns) + ',' + std::string(to_string(event.kind))});
  }
  for (const TrajectorySample& sample : trajectory.strobe) {
    const double tau = static_cast<double>(sample.period) * trajectory.period_length;
    rows.push_back(
        {.tau = tau,
         .order = 1,
         .text = "strobe," + state_cells(tau, sample, columns) + std::string(to_string(sample.contact)) + ','});
  }
  for (const HistorySample& sample : trajectory.history) {
    rows.push_back(
        {.tau = sample.tau,
         .order = 2,
         .text = "sample," + state_cells(sample.tau, sample, columns) + std::string(to_string(sample.contact)) + ','});
  }
  std::ranges::stable_sort(rows, {}, [](const CsvRow& row) { return std::tuple(row.tau, row.order); });
  return rows;
}

}  // namespace

std::string_view to_string(TrajectoryUnits units) {
  switch (units) {
    case TrajectoryUnits::normalised: return "normalised";
    case TrajectoryUnits::si: return "si";
  }
  return "";
}

std::string trajectory_csv(const RealisationKey& key, const Trajectory& trajectory, TrajectoryUnits units) {
  const Written written{.trajectory = &trajectory, .columns = columns_of(trajectory, units), .units = units};
  const Columns& columns = written.columns;
  std::string text = "# format: " + std::string(trajectory_format);
  text += "\n# condition: " + std::to_string(key.condition);
  text += "\n# realisation: " + std::to_string(key.realisation);
  text += "\n# units: " + std::string(to_string(units));
  const Json block = json_of(trajectory.block);
  for (const auto& [name, value] : block.items()) text += "\n# " + name + ": " + value.dump();
  text += "\n# termination: " + std::string(to_string(trajectory.termination));
  text += "\nrow," + std::string(columns.time);
  for (const Column& column : {columns.tilt, columns.tilt_rate, columns.slip, columns.slip_rate}) {
    text += ',' + std::string(column.name);
  }
  text += ",contact,event\n";
  for (const CsvRow& row : rows_of(written)) text += row.text + '\n';
  return text;
}

std::string trajectory_text(const RealisationKey& key, const Trajectory& trajectory, TrajectoryUnits units) {
  const Written written{.trajectory = &trajectory, .columns = columns_of(trajectory, units), .units = units};
  std::string text = "{\n  \"format\": " + Json(trajectory_format).dump();
  text += ",\n  \"condition\": " + std::to_string(key.condition);
  text += ",\n  \"realisation\": " + std::to_string(key.realisation);
  text += ",\n  \"units\": " + Json(to_string(units)).dump();
  text += ",\n  \"block\": " + json_of(trajectory.block).dump();
  text += ",\n  \"strobe\": " + list_of(trajectory.strobe, written);
  text += ",\n  \"events\": " + list_of(trajectory.events, written);
  if (!trajectory.history.empty()) {
    text += ",\n  \"samples_per_period\": " + std::to_string(trajectory.samples_per_period);
    text += ",\n  \"history\": " + list_of(trajectory.history, written);
  }
  text += ",\n  \"peaks\": " + peaks_of(written).dump();
  text += ",\n  \"validity\": " + validity_of(written).dump();
  text += ",\n  \"energy\": " + account_of(trajectory.energy).dump();
  text += ",\n  \"termination\": " + Json(to_string(trajectory.termination)).dump();
  return text + "\n}\n";
}

}  // namespace rocking
