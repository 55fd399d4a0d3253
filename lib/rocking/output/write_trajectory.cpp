#include "rocking/output/write_trajectory.hpp"

#include "rocking/text/json.hpp"

namespace rocking {
namespace {

/// Adds tilt and slip with their rates.
template <class Sample>
void add_state(Json& line, const Sample& sample) {
  line["tilt"] = sample.tilt;
  line["tilt_rate"] = sample.tilt_rate;
  line["slip"] = sample.slip;
  line["slip_rate"] = sample.slip_rate;
}

Json line_of(const TrajectorySample& sample) {
  Json line = Json::object();
  line["period"] = sample.period;
  add_state(line, sample);
  line["contact"] = to_string(sample.contact);
  return line;
}

Json line_of(const TrajectoryEvent& event) {
  Json line = Json::object();
  line["tau"] = event.tau;
  line["kind"] = to_string(event.kind);
  add_state(line, event);
  return line;
}

Json line_of(const HistorySample& sample) {
  Json line = Json::object();
  line["tau"] = sample.tau;
  add_state(line, sample);
  line["contact"] = to_string(sample.contact);
  return line;
}

Json json_of(const dynamics::Block& block) {
  Json json = Json::object();
  json["width_m"] = block.width;
  json["height_m"] = block.height;
  json["gravity_m_s2"] = block.gravity;
  return json;
}

Json validity_of(const Trajectory& trajectory) {
  Json validity = Json::object();
  validity["losses_of_contact"] = trajectory.losses_of_contact;
  validity["first_loss_of_contact"] = nullptr;
  if (trajectory.first_loss_of_contact) validity["first_loss_of_contact"] = *trajectory.first_loss_of_contact;
  validity["losses_before_fall"] = trajectory.losses_before_fall;
  validity["contradictions"] = trajectory.contradictions;
  return validity;
}

Json json_of(const PeakValues& peaks) {
  Json json = Json::object();
  json["tilt"] = peaks.tilt;
  json["tilt_rate"] = peaks.tilt_rate;
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
std::string list_of(const Entries& entries) {
  std::string text = "[";
  for (const auto& entry : entries) {
    if (text.size() > 1) text += ',';
    text += "\n    " + line_of(entry).dump();
  }
  return text + (entries.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string trajectory_text(const RealisationKey& key, const Trajectory& trajectory) {
  std::string text = "{\n  \"format\": " + Json(trajectory_format).dump();
  text += ",\n  \"condition\": " + std::to_string(key.condition);
  text += ",\n  \"realisation\": " + std::to_string(key.realisation);
  text += ",\n  \"block\": " + json_of(trajectory.block).dump();
  text += ",\n  \"strobe\": " + list_of(trajectory.strobe);
  text += ",\n  \"events\": " + list_of(trajectory.events);
  if (!trajectory.history.empty()) {
    text += ",\n  \"samples_per_period\": " + std::to_string(trajectory.samples_per_period);
    text += ",\n  \"history\": " + list_of(trajectory.history);
  }
  text += ",\n  \"peaks\": " + json_of(trajectory.peaks).dump();
  text += ",\n  \"validity\": " + validity_of(trajectory).dump();
  text += ",\n  \"energy\": " + account_of(trajectory.energy).dump();
  text += ",\n  \"termination\": " + Json(to_string(trajectory.termination)).dump();
  return text + "\n}\n";
}

}  // namespace rocking
