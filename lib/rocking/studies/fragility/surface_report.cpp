#include "rocking/fields/container_types.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

static const StructType& fields_of(const SurfaceCoefficient*) {
  using Coefficient = SurfaceCoefficient;
  static const StructType fields{
      "SurfaceCoefficient",
      field<&Coefficient::term>("term", "`1`, `ln x`, `ln y` or `ln x ln y`, the logarithms less those of `centre`"),
      field<&Coefficient::value>("value", "of maximum likelihood"),
      field<&Coefficient::interval>("interval", "of it by bootstrap over records; null: too few samples"),
  };
  return fields;
}

template <>
struct TypeOf<stats::SurfaceTest> {
  static const ValueType& get() {
    using Test = stats::SurfaceTest;
    static const StructType fields{
        "SurfaceTest",
        field<&Test::wald>("wald", "statistic, with records as independent clusters", rule::not_negative),
        field<&Test::samples>("samples", "bootstrap samples of the records in which the likelihood has a maximum"),
        field<&Test::as_large>("as_large", "those whose statistic about the coefficients here is as large"),
        field<&Test::p_value>("p_value", "(as_large + 1)/(samples + 1); null: too few samples", rule::share),
    };
    return fields;
  }
};

static const StructType& fields_of(const SurfaceMedian*) {
  static const StructType fields{
      "SurfaceMedian",
      field<&SurfaceMedian::y>("y", "lower or upper quartile over the tested points", Rule{.above = 0.0}),
      field<&SurfaceMedian::x>("x", "at which the probability is 1/2; null: it does not rise with x",
                               rule::not_negative),
      field<&SurfaceMedian::interval>("interval", "of x by bootstrap over records; null: too few samples",
                                      rule::not_negative),
      field<&SurfaceMedian::is_extrapolated>("extrapolated", "whether it lies outside the tested points"),
  };
  return fields;
}

static const StructType& fields_of(const SurfacePoint*) {
  static const StructType fields{
      "SurfacePoint",
      field<&SurfacePoint::x>("x", "first measure", Rule{.above = 0.0}),
      field<&SurfacePoint::y>("y", "second measure", Rule{.above = 0.0}),
      field<&SurfacePoint::probability>("probability", "of the event", rule::share),
      field<&SurfacePoint::interval>("interval", "of it by bootstrap over records; null: too few samples", rule::share),
      field<&SurfacePoint::is_extrapolated>("extrapolated",
                                            "whether it lies outside the convex hull of the tested points"),
  };
  return fields;
}

static const StructType& fields_of(const TestedPoint*) {
  using Point = TestedPoint;
  static const StructType fields{
      "TestedPoint",
      field<&Point::record>("record", "path of the ground motion"),
      field<&Point::x>("x", "first measure", Rule{.above = 0.0}),
      field<&Point::y>("y", "second measure", Rule{.above = 0.0}),
      field<&Point::overturned, &stats::Proportion::trials>("realisations", "of the condition", Rule{.least = 1.0}),
      field<&Point::overturned, &stats::Proportion::successes>("overturned", "those with the event"),
  };
  return fields;
}

static const StructType& fields_of(const SurfaceRate*) {
  static const StructType fields{
      "SurfaceRate",
      field<&SurfaceRate::hazard>("hazard", "file of the joint hazard"),
      field<&SurfaceRate::value>("value", "sum over its cells of rate times probability [1/year]", rule::not_negative),
      field<&SurfaceRate::interval>("interval", "of it by bootstrap over records; null: too few samples",
                                    rule::not_negative),
      field<&SurfaceRate::extrapolated_share>("extrapolated_share", "from cells outside the tested points",
                                              rule::share),
  };
  return fields;
}

static const StructType& fields_of(const FragilitySurface*) {
  using Surface = FragilitySurface;
  static const StructType fields{
      "FragilitySurface",
      inlined<&Surface::subject>(),
      field<&Surface::measures>("measures", "x and y", Rule{.choices = surface_measure_names}),
      field<&Surface::outcome>("outcome", "whether a surface could be fitted, and why not"),
      field<&Surface::centre>("centre", "geometric means of x and y over the tested points", rule::not_negative),
      field<&Surface::coefficients>(
          "coefficients",
          "of the probit of the probability, of maximum likelihood; that of `ln x ln y` only if its p <= 0.05"),
      field<&Surface::log_likelihood>("log_likelihood", "without binomial coefficients"),
      field<&Surface::interaction>("interaction", "test of the term `ln x ln y`; null: it cannot be fitted"),
      field<&Surface::second>("second", "test of the term `ln y` without interaction; null: no surface"),
      field<&Surface::medians>("medians", "x of probability 1/2 at the quartiles of y"),
      field<&Surface::rate>("annual_rate", "with `--joint-hazard`", {}, WithoutValue::omitted),
      field<&Surface::tested>("tested", "records at their levels", the_only<LinesType<std::vector<TestedPoint>>>()),
      field<&Surface::map>("map", "within the ranges of the tested points: by increasing y, then x",
                           the_only<LinesType<std::vector<SurfacePoint>>>()),
  };
  return fields;
}

const StructType& fields_of(const ReportedSurface*) {
  static const StructType fields{
      "ReportedSurface",
      inlined<&ReportedSurface::run>(),
      inlined<&ReportedSurface::surface>(),
  };
  return fields;
}

namespace {

using stats::FragilityOutcome;

/// Why there is no surface.
std::string reason_of(const FragilitySurface& surface) {
  const std::string both = surface.measures[0] + " and " + surface.measures[1];
  switch (surface.outcome) {
    case FragilityOutcome::never_happened:
      return "the block never " + did(surface.subject.event) + "; add higher intensities";
    case FragilityOutcome::always_happened:
      return "the block always " + did(surface.subject.event) + "; add lower intensities";
    case FragilityOutcome::unresolved: return "some realisations ended without an answer";
    case FragilityOutcome::separated:
      return "a line parts the points with the event from those without it; add records and intensities";
    default: break;
  }
  return "this needs three records, and " + both + " must not follow from each other";
}

std::string p_in_words(const stats::SurfaceTest& test) {
  return test.p_value ? "p = " + significant(*test.p_value, 2) : "no p: too few bootstrap samples have a maximum";
}

std::string value_in_words(double value, const std::optional<stats::Interval>& interval) {
  return significant(value, 3) + (interval ? ' ' + interval_in_words(*interval) : std::string());
}

std::string median_in_words(const SurfaceMedian& median) {
  if (!median.x) return "none";
  return value_in_words(*median.x, median.interval) + (median.is_extrapolated ? " (extrapolated)" : "");
}

/// Whether y matters, and where the medians are.
std::string answer_of(const FragilitySurface& surface) {
  const std::string &x = surface.measures[0], &y = surface.measures[1];
  const auto& p = surface.second->p_value;
  const bool matters = p && *p <= stats::surface_significance;
  const std::string conclusion = matters ? " matters beside "
                                 : p     ? " does not clearly matter beside "
                                         : " is not tested beside ";
  const SurfaceMedian &low = surface.medians.at(0), &high = surface.medians.at(1);
  const auto median = [&x](const SurfaceMedian& at, const std::string& quartile) {
    return "median " + x + ' ' + median_in_words(at) + " at the " + quartile + ", " + significant(at.y, 3) + '\n';
  };
  return y + conclusion + x + " (" + p_in_words(*surface.second) + ")\n" + median(low, "lower quartile of " + y) +
         median(high, "upper quartile");
}

std::string rate_of(const FragilitySurface& surface) {
  const SurfaceRate& rate = *surface.rate;
  const std::string share =
      per_cent(rate.extrapolated_share) + " % of it comes from cells outside the " + "tested points";
  return "mean annual rate of " + words_of(surface.subject.event) +
         " by the joint hazard: " + plain_text(look::number(rate.value, rate.interval, look::rate_form())) +
         (rate.value > 0.0 ? "; " + share : std::string()) + '\n' +
         (rate.extrapolated_share > most_extrapolated_surface ? "warning: " + share + "; add records or levels there\n"
                                                              : "");
}

}  // namespace

std::string surface_table(const std::string& title, const FragilitySurface& surface) {
  std::string text =
      heading_of_curve(title, surface.subject.others) + "surface of " + words_of(surface.subject.event) + ": ";
  if (surface.outcome != FragilityOutcome::fitted) return text + "none is fitted: " + reason_of(surface) + "\n\n";
  text += answer_of(surface);
  if (surface.rate) text += rate_of(surface);
  text += "interaction: ";
  text += surface.interaction ? p_in_words(*surface.interaction) : "cannot be fitted";
  text += surface.coefficients.size() == 4 ? ", taken" : ", left out";
  text +=
      "; trials under one record are not independent, so that p-values and\nintervals are by bootstrap over records\n";
  look::Table table{.title = "probit of the probability, ln x and ln y less those of x = " +
                             significant(surface.centre[0], 6) + ", y = " + significant(surface.centre[1], 6),
                    .notes = "\n"};
  add_columns(table, {"term", "coefficient", "interval"});
  for (const SurfaceCoefficient& found : surface.coefficients) {
    table.rows.push_back({found.term, look::number(found.value, 4), look::interval(found.interval, 3)});
  }
  return text + to_terminal(table);
}

}  // namespace rocking
