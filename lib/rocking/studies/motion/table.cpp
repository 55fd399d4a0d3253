#include <algorithm>
#include <array>

#include "rocking/output/text_table.hpp"
#include "rocking/studies/motion/result.hpp"
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

std::string vertical_cell(const GroundMotionFacts& facts) {
  if (!facts.has_vertical) return "none";
  return facts.vertical_file.value_or("in the file");
}

std::string reading_table(const std::vector<ReportedMotion>& motions) {
  std::vector<TextRow> rows{{"file", "format", "unit", "samples", "step [s]", "duration [s]", "vertical component"}};
  const bool has_columns =
      std::ranges::any_of(motions, [](const ReportedMotion& motion) { return !motion.facts.columns.empty(); });
  if (has_columns) rows.front().emplace_back("columns");
  for (const ReportedMotion& motion : motions) {
    const GroundMotionFacts& facts = motion.facts;
    rows.push_back({facts.file, facts.format, facts.unit + (facts.unit_is_assumed ? " (assumed)" : ""),
                    std::to_string(facts.samples), facts.time_step_s ? significant(*facts.time_step_s, 6) : "uneven",
                    significant(facts.duration_s, 6), vertical_cell(facts)});
    if (!has_columns) continue;
    std::string columns;
    for (const std::string& column : facts.columns) columns += (columns.empty() ? "" : ",") + column;
    rows.back().push_back(columns.empty() ? "-" : columns);
  }
  return aligned(rows);
}

std::string measures_table(const MotionReport& report, Extent extent) {
  std::vector<TextRow> rows{{"file"}};
  for (const MeasureColumn& column : measure_columns) rows.front().emplace_back(column.heading);
  const bool has_vertical = std::ranges::any_of(
      report.motions, [](const ReportedMotion& motion) { return motion.vertical_pga_g.has_value(); });
  if (has_vertical) rows.front().emplace_back("vertical PGA [g]");
  if (report.block) rows.front().emplace_back("uplift scale");
  for (const ReportedMotion& motion : report.motions) {
    rows.push_back({motion.facts.file});
    for (const MeasureColumn& column : measure_columns) {
      rows.back().push_back(significant(column.value(motion.measures), 4));
    }
    if (has_vertical) {
      rows.back().push_back(motion.vertical_pga_g ? significant(*motion.vertical_pga_g, 4) : "none");
    }
    if (!motion.uplift_scale) continue;
    rows.back().push_back(*motion.uplift_scale ? significant(**motion.uplift_scale, 4) : "none");
  }
  if (extent == Extent::one_screen) rows.resize(std::min(rows.size(), most_screen_rows));
  return aligned(rows);
}

std::string spectrum_table(const std::vector<ReportedMotion>& motions) {
  std::vector<TextRow> rows{{"file", "T [s]", "PSa [g]", "Sv [m/s]", "Sd [m]", "PSv [m/s]", "absolute Sa [g]"}};
  for (const ReportedMotion& motion : motions) {
    for (const SpectrumEntry& entry : motion.spectrum) {
      rows.push_back({motion.facts.file, significant(entry.period_s, 4), significant(entry.sa_g, 4),
                      significant(entry.sv_m_s, 4), significant(entry.sd_m, 4), significant(entry.psv_m_s, 4),
                      significant(entry.sa_absolute_g, 4)});
    }
  }
  return aligned(rows);
}

/// Smallest, median and largest value over the motions at each period; the motions have the same periods.
std::string spectra_summary(const std::vector<ReportedMotion>& motions) {
  std::vector<TextRow> rows{{"T [s]", "PSa [g] least", "median", "largest"}};
  for (std::size_t i = 0; i < motions.front().spectrum.size(); ++i) {
    std::vector<double> values;
    for (const ReportedMotion& motion : motions) values.push_back(motion.spectrum[i].sa_g);
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    rows.push_back({significant(motions.front().spectrum[i].period_s, 4), significant(values.front(), 4),
                    significant(median, 4), significant(values.back(), 4)});
  }
  return aligned(rows);
}

}  // namespace

std::string motion_table(const MotionReport& report, Extent extent) {
  const std::string measures = measures_table(report, extent);
  const bool has_spectrum = !report.motions.empty() && !report.motions.front().spectrum.empty();
  const std::string heading = "\nresponse spectrum, " + significant(100.0 * report.damping, 3) + " % damping";
  const std::string whole = measures + '\n' + reading_table(report.motions) +
                            (has_spectrum ? heading + '\n' + spectrum_table(report.motions) : "");
  if (is_printed_whole(whole, extent)) return whole;
  return measures +
         (has_spectrum
              ? heading + ", over " + counted(report.motions.size(), "motion") + '\n' + spectra_summary(report.motions)
              : "") +
         "more rows: --all, and --json\n";
}

}  // namespace rocking
