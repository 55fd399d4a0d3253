#include <algorithm>
#include <array>

#include "rocking/look/table.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/studies/motion/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
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

look::Table reading_table(const std::vector<ReportedMotion>& motions) {
  look::Table table;
  add_columns(table, {"file", "format", "unit", "samples", "step [s]", "duration [s]", "vertical component"});
  const bool has_columns =
      std::ranges::any_of(motions, [](const ReportedMotion& motion) { return !motion.facts.columns.empty(); });
  if (has_columns) add_columns(table, {"columns"});
  for (const ReportedMotion& motion : motions) {
    const GroundMotionFacts& facts = motion.facts;
    look::Row& row = table.rows.emplace_back(
        look::Row{facts.file, facts.format, facts.unit + (facts.unit_is_assumed ? " (assumed)" : ""),
                  look::whole(facts.samples), facts.time_step_s ? look::number(facts.time_step_s, 6) : "uneven",
                  look::number(facts.duration_s, 6), vertical_cell(facts)});
    if (!has_columns) continue;
    std::string columns;
    for (const std::string& column : facts.columns) columns += (columns.empty() ? "" : ",") + column;
    row.emplace_back(columns.empty() ? "-" : columns);
  }
  return table;
}

look::Table measures_table(const MotionReport& report, Extent extent) {
  look::Table table{.absent = "none"};
  add_columns(table, {"file"});
  for (const MeasureColumn& column : measure_columns) add_columns(table, {column.heading});
  const bool has_vertical = std::ranges::any_of(
      report.motions, [](const ReportedMotion& motion) { return motion.vertical_pga_g.has_value(); });
  if (has_vertical) add_columns(table, {"vertical PGA [g]"});
  if (report.block) add_columns(table, {"uplift scale"});
  for (const ReportedMotion& motion : report.motions) {
    look::Row& row = table.rows.emplace_back(look::Row{motion.facts.file});
    for (const MeasureColumn& column : measure_columns) row.push_back(number(column.value(motion.measures), 4));
    if (has_vertical) row.push_back(number(motion.vertical_pga_g, 4));
    if (motion.uplift_scale) row.push_back(number(*motion.uplift_scale, 4));
  }
  if (extent == Extent::one_screen) table.rows.resize(std::min(table.rows.size(), most_screen_rows - 1));
  return table;
}

look::Table spectrum_table(const std::vector<ReportedMotion>& motions) {
  look::Table table;
  add_columns(table, {"file", "T [s]", "PSa [g]", "Sv [m/s]", "Sd [m]", "PSv [m/s]", "absolute Sa [g]"});
  for (const ReportedMotion& motion : motions) {
    for (const SpectralPoint& entry : motion.spectrum) {
      look::Row& row = table.rows.emplace_back(look::Row{motion.facts.file});
      for (const double value :
           {entry.period_s, entry.sa_g, entry.sv_m_s, entry.sd_m, entry.psv_m_s, entry.sa_absolute_g}) {
        row.push_back(number(value, 4));
      }
    }
  }
  return table;
}

/// Smallest, median and largest value over the motions at each period; the motions have the same periods.
look::Table spectra_summary(const std::vector<ReportedMotion>& motions) {
  look::Table table;
  add_columns(table, {"T [s]", "PSa [g] least", "median", "largest"});
  for (std::size_t i = 0; i < motions.front().spectrum.size(); ++i) {
    std::vector<double> values;
    for (const ReportedMotion& motion : motions) values.push_back(motion.spectrum[i].sa_g);
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    table.rows.push_back({number(motions.front().spectrum[i].period_s, 4), number(values.front(), 4), number(median, 4),
                          number(values.back(), 4)});
  }
  return table;
}

}  // namespace

/// PGA, PGV, and what lifts the block, in a sentence; of several motions their ranges, and apart from them of floors.
static std::string answer_of(const MotionReport& report) {
  std::vector<const ReportedMotion*> grounds, floors;
  for (const ReportedMotion& motion : report.motions) {
    const bool is_floor = floors.size() < grounds.size() && grounds.back()->floor_peak_g;
    (is_floor ? floors : grounds).push_back(&motion);
  }
  const bool is_one = grounds.size() == 1;
  const auto measures_of = [is_one](const std::vector<const ReportedMotion*>& motions) {
    NumberRange pga, pgv, uplift;
    for (const ReportedMotion* motion : motions) {
      pga.add(motion->measures.pga_g);
      pgv.add(motion->measures.pgv_m_s);
      if (const auto scale = motion->uplift_scale.value_or(std::nullopt)) uplift.add(*scale);
    }
    return (is_one ? " has a PGA of " : " have a PGA of ") + pga.text() + " g and a PGV of " + pgv.text() + " m/s" +
           (uplift.least > uplift.largest ? ""
            : is_one                      ? ", and lifts the block at " + uplift.text() + " times its strength"
                                          : ", and lift the block at " + uplift.text() + " times their strength");
  };
  return (is_one ? "the ground motion " + grounds.front()->facts.file : counted(grounds.size(), "ground motion")) +
         measures_of(grounds) +
         (floors.empty() ? "" : (is_one ? "; on the floor it" : "; on the floor they") + measures_of(floors));
}

std::string motion_table(const MotionReport& report, Extent extent) {
  const std::string measures = answer_of(report) + "\n\n" + to_terminal(measures_table(report, extent));
  const bool has_spectrum = !report.motions.empty() && !report.motions.front().spectrum.empty();
  const auto spectra = [&](look::Table table, const std::string& of) {
    table.title = "\nresponse spectrum, " + significant(100.0 * report.damping, 3) + " % damping" + of;
    return to_terminal(table);
  };
  const std::string whole = measures + '\n' + to_terminal(reading_table(report.motions)) +
                            (has_spectrum ? spectra(spectrum_table(report.motions), "") : "");
  if (is_printed_whole(whole, extent)) return whole;
  return measures +
         (has_spectrum ? spectra(spectra_summary(report.motions), ", over " + counted(report.motions.size(), "motion"))
                       : "") +
         "more rows: --all, and --json\n";
}

}  // namespace rocking
