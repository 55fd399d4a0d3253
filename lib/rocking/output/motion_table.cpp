#include <array>

#include "rocking/output/motion_report.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

struct MeasureColumn {
  const char* heading;
  double (*value)(const IntensityMeasures&);
};

constexpr std::array<MeasureColumn, 6> measure_columns{
    {{"PGA [g]", [](const IntensityMeasures& of) { return of.pga_g; }},
     {"PGV [m/s]", [](const IntensityMeasures& of) { return of.pgv_m_s; }},
     {"PGD [m]", [](const IntensityMeasures& of) { return of.pgd_m; }},
     {"Arias [m/s]", [](const IntensityMeasures& of) { return of.arias_m_s; }},
     {"CAV [m/s]", [](const IntensityMeasures& of) { return of.cav_m_s; }},
     {"D5-95 [s]", [](const IntensityMeasures& of) { return of.significant_to_s - of.significant_from_s; }}}};

std::string reading_table(const std::vector<ReportedMotion>& motions) {
  std::vector<TextRow> rows{{"file", "format", "unit", "samples", "step [s]", "duration [s]"}};
  for (const ReportedMotion& motion : motions) {
    rows.push_back({motion.file, motion.format, motion.unit, std::to_string(motion.samples),
                    motion.time_step_s ? significant(*motion.time_step_s, 6) : "uneven",
                    significant(motion.duration_s, 6)});
  }
  return aligned(rows);
}

std::string measures_table(const MotionReport& report) {
  std::vector<TextRow> rows{{"file"}};
  for (const MeasureColumn& column : measure_columns) rows.front().emplace_back(column.heading);
  if (report.block) rows.front().emplace_back("uplift scale");
  for (const ReportedMotion& motion : report.motions) {
    rows.push_back({motion.file});
    for (const MeasureColumn& column : measure_columns) {
      rows.back().push_back(significant(column.value(motion.measures), 4));
    }
    if (!motion.uplift_scale) continue;
    rows.back().push_back(*motion.uplift_scale ? significant(**motion.uplift_scale, 4) : "none");
  }
  return aligned(rows);
}

std::string spectrum_table(const std::vector<ReportedMotion>& motions) {
  std::vector<TextRow> rows{{"file", "T [s]", "Sa [g]", "Sv [m/s]", "Sd [m]", "PSa [g]", "PSv [m/s]"}};
  for (const ReportedMotion& motion : motions) {
    for (const SpectrumEntry& entry : motion.spectrum) {
      rows.push_back({motion.file, significant(entry.period_s, 4), significant(entry.sa_g, 4),
                      significant(entry.sv_m_s, 4), significant(entry.sd_m, 4), significant(entry.psa_g, 4),
                      significant(entry.psv_m_s, 4)});
    }
  }
  return aligned(rows);
}

}  // namespace

std::string motion_table(const MotionReport& report) {
  std::string text = reading_table(report.motions) + '\n' + measures_table(report);
  if (report.motions.empty() || report.motions.front().spectrum.empty()) return text;
  return text + "\nresponse spectrum, " + significant(100.0 * report.damping, 3) + " % damping\n" +
         spectrum_table(report.motions);
}

}  // namespace rocking
