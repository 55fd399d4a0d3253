#include "rocking/studies/motion/study.hpp"

#include "rocking/fields/container_types.hpp"

namespace rocking {

static const StructType& fields_of(const SpectralPoint*) {
  using Entry = SpectralPoint;
  static const StructType fields{
      "SpectrumEntry",
      field<&Entry::period_s>("period_s", "of the undamped oscillator [s]", rule::positive),
      field<&Entry::sa_g>("sa_g",
                          "spectral acceleration of hazard and ground-motion models: the pseudo-acceleration omega^2 "
                          "sd_m, over gravity",
                          rule::not_negative),
      field<&Entry::sa_absolute_g>("sa_absolute_g", "largest absolute acceleration of the oscillator, over gravity",
                                   rule::not_negative),
      field<&Entry::sv_m_s>("sv_m_s", "largest velocity relative to the base [m/s]", rule::not_negative),
      field<&Entry::sd_m>("sd_m", "largest displacement relative to the base [m]", rule::not_negative),
      field<&Entry::psv_m_s>("psv_m_s", "pseudo-velocity, omega sd_m [m/s]", rule::not_negative),
  };
  return fields;
}

static const StructType& fields_of(const MotionSeries*) {
  using Series = MotionSeries;
  static const StructType fields{
      "MotionSeries",
      field<&Series::time_s>("time_s", "of the samples [s]"),
      field<&Series::acceleration_g>("acceleration_g", "of the base over gravity"),
      field<&Series::velocity_m_s>("velocity_m_s", "of the base, from rest [m/s]"),
      field<&Series::displacement_m>("displacement_m", "of the base, from rest [m]"),
      field<&Series::vertical_g>("vertical_g", "vertical acceleration of the base over gravity, where there is one", {},
                                 WithoutValue::omitted),
      field<&Series::spectrum>("spectrum", "response spectrum at 120 periods, for a figure"),
  };
  return fields;
}

static const StructType& fields_of(const IntensityMeasures*) {
  using Measures = IntensityMeasures;
  static const StructType fields{
      "IntensityMeasures",
      field<&Measures::pga_g>("pga_g", "largest abs(a) over g", rule::not_negative),
      field<&Measures::pga_time_s>("pga_time_s", "when it is reached first [s]"),
      field<&Measures::pgv_m_s>("pgv_m_s", "largest absolute velocity of the base, from rest at the first sample [m/s]",
                                rule::not_negative),
      field<&Measures::pgd_m>("pgd_m", "largest absolute displacement of the base, likewise [m]", rule::not_negative),
      field<&Measures::arias_m_s>("arias_m_s",
                                  "Arias intensity, pi/(2 g) times the integral of a^2 [m/s] (Arias 1970, in: Seismic "
                                  "Design for Nuclear Power Plants, MIT Press, 438-483)",
                                  rule::not_negative),
      field<&Measures::cav_m_s>("cav_m_s",
                                "cumulative absolute velocity, the integral of abs(a) [m/s] (EPRI 1988, NP-5930)",
                                rule::not_negative),
      derived<[](const IntensityMeasures& of) { return of.significant_to_s - of.significant_from_s; }>(
          "significant_duration_s",
          "time from 5 to 95 % of the Arias intensity [s] (Trifunac & Brady 1975, BSSA 65(3), 581-626)",
          rule::not_negative),
      field<&Measures::significant_from_s>("significant_from_s", "when it begins [s]"),
      field<&Measures::significant_to_s>("significant_to_s", "when it ends [s]"),
  };
  return fields;
}

static const StructType& fields_of(const ReportedMotion*) {
  using Motion = ReportedMotion;
  static const StructType fields{
      "GroundMotion",
      inlined<&Motion::facts>(),
      field<&Motion::sha256>("sha256", "of the file"),
      inlined<&Motion::measures>(),
      field<&Motion::vertical_pga_g>("vertical_pga_g", "of the vertical component, or null", rule::not_negative),
      field<&Motion::uplift_scale>(
          "uplift_scale",
          "with `--block`: the least scale at which abs(alpha) reaches (B/H)(1 + alpha_v); null if no scale does",
          rule::positive, WithoutValue::omitted),
      field<&Motion::floor_peak_g>("floor_peak_g",
                                   "with `--building`: largest abs(a) of the floor over g, whose motion follows",
                                   rule::not_negative, WithoutValue::omitted),
      field<&Motion::spectrum>("spectrum", "response spectrum at the periods that were asked for"),
      field<&Motion::series>("series", "with `--series`: the motion at its samples, for `rocking report`", {},
                             WithoutValue::omitted),
  };
  return fields;
}

static const StructType& fields_of(const BlockSize*) {
  static const StructType fields{
      "BlockSize",
      field<&BlockSize::width_m>("width_m", "[m]", rule::positive),
      field<&BlockSize::height_m>("height_m", "[m]", rule::positive),
  };
  return fields;
}

const StructType& fields_of(const MotionReport*) {
  static const StructType fields{
      "GroundMotions",
      field<&MotionReport::gravity_m_s2>("gravity_m_s2", "1 g [m/s^2]", rule::positive),
      field<&MotionReport::damping>("damping", "ratio, of the response spectra", {.least = 0.0, .below = 1.0}),
      field<&MotionReport::block>("block", "whose least scale of uplift was asked for", rule::none,
                                  WithoutValue::omitted),
      field<&MotionReport::motions>("motions", "one for each file"),
  };
  return fields;
}

static void check_lengths(const MotionReport& report, const ReadingPlace& place) {
  for (std::size_t i = 0; i < report.motions.size(); ++i) {
    if (!report.motions[i].series) continue;
    const MotionSeries& series = *report.motions[i].series;
    const ReadingPlace at = place.at("motions").at(std::to_string(i)).at("series");
    const std::size_t samples = series.time_s.size();
    if (series.acceleration_g.size() != samples) at.at("acceleration_g").reject({}, "differs in length from time_s");
    if (series.velocity_m_s.size() != samples) at.at("velocity_m_s").reject({}, "differs in length from time_s");
    if (series.vertical_g && series.vertical_g->size() != samples) {
      at.at("vertical_g").reject({}, "differs in length from time_s");
    }
    if (series.displacement_m.size() != samples) at.at("displacement_m").reject({}, "differs in length from time_s");
  }
}

const DocumentOf<MotionReport>& motion_document() {
  static const DocumentOf<MotionReport> document("rocking.motion/1", "Ground motions and their intensity measures.",
                                                 check_lengths);
  return document;
}

namespace {

MotionSeries series_of(const GroundMotion& motion, const MotionQuestion& question) {
  MotionSeries series;
  for (const BasePoint& point : base_motion_of(motion.samples, question.gravity)) {
    series.time_s.push_back(point.time);
    series.acceleration_g.push_back(point.acceleration / question.gravity);
    series.velocity_m_s.push_back(point.velocity);
    series.displacement_m.push_back(point.displacement);
  }
  if (motion.has_vertical) {
    series.vertical_g.emplace();
    for (const auto& sample : motion.samples) series.vertical_g->push_back(sample.vertical);
  }
  constexpr int periods_of_a_curve = 120;
  for (const double period : spaced_periods(0.02, 10.0, periods_of_a_curve)) {
    series.spectrum.push_back(spectral_point(motion.samples, question.gravity, period, question.damping));
  }
  return series;
}

ReportedMotion reported(const MeasuredMotion& found, const MotionQuestion& question, MotionDetail detail) {
  const GroundMotion& motion = *found.motion;
  ReportedMotion reported{.facts = facts_of(motion),
                          .sha256 = found.sha256,
                          .measures = found.measures,
                          .vertical_pga_g = {},
                          .uplift_scale = {},
                          .floor_peak_g = found.floor_peak_g,
                          .spectrum = found.spectrum,
                          .series = {}};
  if (motion.has_vertical) reported.vertical_pga_g = found.measures.vertical_pga_g;
  if (question.block) reported.uplift_scale = found.uplift_scale;
  if (detail == MotionDetail::series) reported.series = series_of(motion, question);
  return reported;
}

}  // namespace

MotionReport motion_report(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question,
                           MotionDetail detail) {
  MotionReport report{
      .gravity_m_s2 = question.gravity, .damping = question.damping, .block = std::nullopt, .motions = {}};
  if (question.block) report.block = {.width_m = question.block->front(), .height_m = question.block->back()};
  for (const MeasuredMotion& found : motions) report.motions.push_back(reported(found, question, detail));
  return report;
}

}  // namespace rocking
