#include "rocking/output/write_motion.hpp"

#include <array>
#include <string_view>

#include "rocking/output/text_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr double two_pi = 0x1.921fb54442d18p+2;

Json spectral_json(const SpectralPoint& point, double gravity) {
  const double omega = two_pi / point.period_s;
  return {{"period_s", point.period_s},
          {"sa_g", point.sa_m_s2 / gravity},
          {"sv_m_s", point.sv_m_s},
          {"sd_m", point.sd_m},
          {"psa_g", omega * omega * point.sd_m / gravity},
          {"psv_m_s", omega * point.sd_m}};
}

Json spectrum_json(const std::vector<SpectralPoint>& spectrum, double gravity) {
  Json json = Json::array();
  for (const SpectralPoint& point : spectrum) json.push_back(spectral_json(point, gravity));
  return json;
}

Json series_json(const GroundMotion& motion, const MotionQuestion& question) {
  Json json = Json::object();
  for (const char* key : {"time_s", "acceleration_g", "velocity_m_s", "displacement_m"}) json[key] = Json::array();
  for (const BasePoint& point : base_motion_of(motion.samples, question.gravity)) {
    json["time_s"].push_back(point.time);
    json["acceleration_g"].push_back(point.acceleration / question.gravity);
    json["velocity_m_s"].push_back(point.velocity);
    json["displacement_m"].push_back(point.displacement);
  }
  constexpr int periods_of_a_curve = 120;
  std::vector<SpectralPoint> spectrum;
  for (const double period : spaced_periods(0.02, 10.0, periods_of_a_curve)) {
    spectrum.push_back(spectral_point(motion.samples, question.gravity, period, question.damping));
  }
  json["spectrum"] = spectrum_json(spectrum, question.gravity);
  return json;
}

template <class Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json measured_motion_json(const MeasuredMotion& found, const MotionQuestion& question, MotionDetail detail) {
  const GroundMotion& motion = *found.motion;
  const IntensityMeasures& measures = found.measures;
  Json json = Json::object();
  json["file"] = motion.name;
  json["sha256"] = found.sha256;
  json["format"] = motion.format;
  json["unit"] = motion.unit;
  json["samples"] = motion.samples.size();
  json["declared_samples"] = json_or_null(motion.declared);
  json["time_step_s"] = json_or_null(motion.time_step);
  json["duration_s"] = motion.samples.back().time - motion.samples.front().time;
  json["warnings"] = motion.warnings;
  json["pga_g"] = measures.pga_g;
  json["pga_time_s"] = measures.pga_time_s;
  json["pgv_m_s"] = measures.pgv_m_s;
  json["pgd_m"] = measures.pgd_m;
  json["arias_m_s"] = measures.arias_m_s;
  json["cav_m_s"] = measures.cav_m_s;
  json["significant_duration_s"] = measures.significant_to_s - measures.significant_from_s;
  json["significant_from_s"] = measures.significant_from_s;
  json["significant_to_s"] = measures.significant_to_s;
  json["vertical_pga_g"] = motion.has_vertical ? Json(measures.vertical_pga_g) : Json();
  if (question.block) json["uplift_scale"] = json_or_null(found.uplift_scale);
  json["spectrum"] = spectrum_json(found.spectrum, question.gravity);
  if (detail == MotionDetail::series) json["series"] = series_json(motion, question);
  return json;
}

struct MeasureColumn {
  const char* heading;
  double (*value)(const MeasuredMotion&);
};

constexpr std::array<MeasureColumn, 6> measure_columns{
    {{"PGA [g]", [](const MeasuredMotion& m) { return m.measures.pga_g; }},
     {"PGV [m/s]", [](const MeasuredMotion& m) { return m.measures.pgv_m_s; }},
     {"PGD [m]", [](const MeasuredMotion& m) { return m.measures.pgd_m; }},
     {"Arias [m/s]", [](const MeasuredMotion& m) { return m.measures.arias_m_s; }},
     {"CAV [m/s]", [](const MeasuredMotion& m) { return m.measures.cav_m_s; }},
     {"D5-95 [s]",
      [](const MeasuredMotion& m) { return m.measures.significant_to_s - m.measures.significant_from_s; }}}};

std::string reading_table(const std::vector<MeasuredMotion>& motions) {
  std::vector<TextRow> rows{{"file", "format", "unit", "samples", "step [s]", "duration [s]"}};
  for (const MeasuredMotion& found : motions) {
    const GroundMotion& motion = *found.motion;
    rows.push_back({motion.name, motion.format, motion.unit, std::to_string(motion.samples.size()),
                    motion.time_step ? significant(*motion.time_step, 6) : "uneven",
                    significant(motion.samples.back().time - motion.samples.front().time, 6)});
  }
  return aligned(rows);
}

std::string measures_table(const std::vector<MeasuredMotion>& motions, bool has_block) {
  std::vector<TextRow> rows{{"file"}};
  for (const MeasureColumn& column : measure_columns) rows.front().emplace_back(column.heading);
  if (has_block) rows.front().emplace_back("uplift scale");
  for (const MeasuredMotion& found : motions) {
    rows.push_back({found.motion->name});
    for (const MeasureColumn& column : measure_columns) rows.back().push_back(significant(column.value(found), 4));
    if (has_block) rows.back().push_back(found.uplift_scale ? significant(*found.uplift_scale, 4) : "none");
  }
  return aligned(rows);
}

std::string spectrum_table(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question) {
  std::vector<TextRow> rows{{"file", "T [s]", "Sa [g]", "Sv [m/s]", "Sd [m]", "PSa [g]", "PSv [m/s]"}};
  for (const MeasuredMotion& found : motions) {
    for (const SpectralPoint& point : found.spectrum) {
      const double omega = two_pi / point.period_s;
      rows.push_back({found.motion->name, significant(point.period_s, 4),
                      significant(point.sa_m_s2 / question.gravity, 4), significant(point.sv_m_s, 4),
                      significant(point.sd_m, 4), significant(omega * omega * point.sd_m / question.gravity, 4),
                      significant(omega * point.sd_m, 4)});
    }
  }
  return aligned(rows);
}

}  // namespace

std::string motion_text(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question,
                        MotionDetail detail) {
  Json json = Json::object();
  json["format"] = motion_format;
  json["gravity_m_s2"] = question.gravity;
  json["damping"] = question.damping;
  if (question.block) json["block"] = {{"width_m", question.block->width}, {"height_m", question.block->height}};
  json["motions"] = Json::array();
  for (const MeasuredMotion& found : motions) json["motions"].push_back(measured_motion_json(found, question, detail));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';  // a file name may be no UTF-8
}

std::string motion_table(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question) {
  std::string text = reading_table(motions) + '\n' + measures_table(motions, question.block.has_value());
  if (question.periods.empty()) return text;
  return text + "\nresponse spectrum, " + significant(100.0 * question.damping, 3) + " % damping\n" +
         spectrum_table(motions, question);
}

}  // namespace rocking
