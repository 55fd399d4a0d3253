#include "rocking/studies/fragility/words.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
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
