#include "rocking/studies/fragility/figure.hpp"

#include <set>
#include <utility>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

void add_curve(const ReportedSuite& reported, const PlaceInPanel& place, Figure& figure) {
  add_suite(reported.curve, place, figure);
}

std::vector<std::optional<Shaking>> shakings_of(const ReportedCurve& reported) {
  std::vector<std::optional<Shaking>> shakings;
  for (const FragilityLevel& level : reported.curve.levels) shakings.push_back(level.shaking);
  return shakings;
}

/// Ground motions have neither amplitude nor frequency.
std::vector<std::optional<Shaking>> shakings_of(const ReportedSuite&) { return {}; }

template <class Reported>
Panel panel_for(const Reported& reported) {
  const CurveSubject& subject = reported.curve.subject;
  return {.title = reported.run.title,
          .x = axis_of_parameter(subject.parameter, shakings_of(reported)),
          .y = {.quantity = "probability of " + probability_of(subject.event), .symbol = "P", .low = 0.0, .high = 1.0}};
}

/// Which intensities count, where a law also gives a probability below.
std::string uplift_sentence(const CurveSubject& subject) {
  if (!subject.least_uplift) return "";
  return " Probabilities count " + counted_from_in_words(subject) + why_counted_in_words(subject) + '.';
}

/// `2.31 [2.20, 2.43]`.
std::string value_and_interval(double value, const stats::Interval& interval) {
  return significant(value, 3) + ' ' + interval_in_words(interval);
}

/// How much of the rate, if there is one, the hazard curve does not give, and what needs a look.
std::string beyond_the_hazard(const ReportedSuite& reported) {
  const AnnualRate* rate = rate_of(reported);
  if (rate == nullptr || !(rate->value > 0.0)) return "";
  std::string text = ' ' + extrapolated_hazard_in_words(*rate) + '.';
  for (const std::string& doubt : hazard_doubts(*rate)) text += " Warning: " + doubt + '.';
  return text;
}

/// Which of several options is described, with its rate; the headline has that of the only one.
std::string option_in_words(const ReportedSuite& reported) {
  const CurveSubject& subject = reported.curve.subject;
  return reported.rate ? rate_sentence(subject, *reported.rate) + ". " : values_in_words(subject.others) + ": ";
}

/// What the law of the suite says, `median PGA = 0.36 [0.31, 0.42] g, dispersion 0.45 [0.3, 0.6]`.
std::string law_in_words(const SuiteCurve& curve) {
  const SuiteEstimate& median = curve.pooled->median;
  const SuiteEstimate& dispersion = curve.pooled->dispersion;
  return "median " + at_intensity(curve.subject, value_and_interval(median.value, median.interval)) +
         (curve.pooled->is_extrapolated ? " (extrapolated beyond the levels)" : "") + ", dispersion " +
         value_and_interval(dispersion.value, dispersion.interval);
}

std::string law_sentence(const SuiteCurve& curve) {
  if (!curve.pooled) {
    std::string outcome(to_string(curve.outcome));
    std::ranges::replace(outcome, '_', ' ');
    return "No law of the suite is fitted: " + outcome + '.';
  }
  if (curve.outcome != stats::FragilityOutcome::rejected)
    return "Lognormal law of the suite: " + law_in_words(curve) + '.';
  return "The lognormal law (" + law_in_words(curve) +
         ") is rejected: the curve shows the nearest shares that do not decrease.";
}

/// Of a suite the headline begins the description.
std::string description_of(const ReportedSuite& reported, bool is_alone) {
  return (is_alone ? "" : option_in_words(reported)) + law_sentence(reported.curve) + beyond_the_hazard(reported) +
         uplift_sentence(reported.curve.subject);
}

std::string description_of(const ReportedCurve& reported, bool) {
  const FragilityCurve& curve = reported.curve;
  const std::string others = values_in_words(curve.subject.others);
  const std::string text =
      reported.run.title + (others.empty() ? "" : ", " + others) + ", " + probability_of(curve.subject.event);
  if (curve.is_isotonic()) return text + ": the lognormal function is rejected; isotonic estimate.";
  if (!curve.law) return text + ": no function fitted (" + std::string(to_string(curve.outcome)) + ").";
  return text + ": median " + bounded_in_words(curve.law->median) +
         (curve.law->is_extrapolated ? " (extrapolated beyond the levels)" : "") + ", dispersion " +
         bounded_in_words(curve.law->dispersion) + '.' + uplift_sentence(curve.subject);
}

/// Whether the run has one curve.
bool is_alone(const FragilityReport& report, const CurveRun& run) {
  const auto belongs = [&run](const auto& curve) {
    return std::visit([&run](const auto& one) { return one.run.experiment == run.experiment; }, curve);
  };
  return std::ranges::count_if(report.curves, belongs) == 1;
}

/// What the curves of a figure show.
struct Content {
  bool has_suite = false, has_records = false, has_curve = false;
  bool has_law = false, has_isotonic = false, has_rare = false;
  std::set<std::string> events;    ///< `overturned`, or `peak tilt > 0.5`
  std::set<std::string> subjects;  ///< the same as that of a probability
};

void add_to(Content& content, const FragilityReport& report, const ReportedSuite& reported) {
  content.has_suite = true;
  content.has_records = content.has_records || is_alone(report, reported.run);
  content.has_rare = content.has_rare || !reported.curve.rare.empty();
}
void add_to(Content& content, const FragilityReport&, const ReportedCurve& reported) {
  if (reported.curve.levels.empty()) return;
  content.has_curve = true;
  content.has_rare = content.has_rare || !reported.curve.rare.empty();
  content.has_law = content.has_law || reported.curve.law;
  content.has_isotonic = content.has_isotonic || reported.curve.is_isotonic();
}

Content content_of(const FragilityReport& report) {
  Content content;
  for (const auto& curve : report.curves) {
    std::visit(
        [&](const auto& reported) {
          add_to(content, report, reported);
          content.events.insert(event_in_words(reported.curve.subject.event));
          content.subjects.insert(probability_of(reported.curve.subject.event));
        },
        curve);
  }
  return content;
}

/// How to read the lines, as far as the figure has them.
std::string caption_of_shares(const Content& content) {
  std::string caption;
  if (content.has_suite) {
    caption =
        "Markers: means over the records of the shares of their realisations. Thick lines and ribbons: the law of the "
        "suite, with scatter between and within records, or, where none holds, the nearest shares that do not "
        "decrease; with the bootstrap interval over records at the levels, interpolated between them.";
    if (content.has_records) caption += " Thin grey lines: the shares of each record.";
  }
  if (!content.has_curve) return caption;
  if (!caption.empty()) caption += ' ';
  const std::string event = content.events.size() == 1 ? *content.events.begin() : "";
  caption += "Markers: share of the realisations " +
             (event == event_in_words(ResponseEvent()) ? std::string("that overturned")
              : event.empty()                          ? std::string("with the event of each curve")
                                                       : "with " + event) +
             ", with its exact interval.";
  if (content.has_law) {
    caption += " Lines and ribbons: the lognormal function of maximum likelihood, with its confidence band.";
  }
  if (content.has_isotonic) {
    caption +=
        " Steps and boxes: the most likely probabilities that do not decrease, with a band for all levels at once.";
  }
  return caption;
}

std::string caption_of(const Content& content) {
  return caption_of_shares(content) +
         (content.has_rare
              ? " Diamonds: probabilities that rocking rare estimated, with their intervals; no law is fitted to them."
              : "");
}

/// Draws the curves of a report one after another; those of a run share a panel.
class CurveDrawing {
 public:
  CurveDrawing(const FragilityReport& report, Figure& figure) : report_(report), figure_(figure) {}

  template <class Reported>
  void add(const Reported& reported) {
    if (reported.curve.levels.empty()) return;
    const std::string quantity = "probability of " + probability_of(reported.curve.subject.event);
    if (run_ != reported.run.experiment) {
      figure_.panels.push_back(panel_for(reported));
      run_ = reported.run.experiment;
      number_ = 0;
    } else if (figure_.panels.back().y.quantity != quantity) {
      figure_.panels.back().y.quantity = "probability";
    }
    const bool is_alone = analysis::is_alone(report_, reported.run);
    add_curve(reported, {.number = number_++, .is_alone = is_alone}, figure_);
    const bool goes_on = !figure_.description.empty() && !figure_.description.ends_with('\n');
    figure_.description += (goes_on ? "\n" : "") + description_of(reported, is_alone);
  }

 private:
  const FragilityReport& report_;
  Figure& figure_;
  std::optional<base::Sha256> run_;  ///< of the last panel
  std::size_t number_ = 0;           ///< of the next curve in it
};

}  // namespace

Figure fragility_figure(const FragilityReport& report) {
  const Content content = content_of(report);
  Figure figure{.name = "fragility",
                .title = "Probability" + (content.subjects.size() == 1 ? " of " + *content.subjects.begin() : "") +
                         " as a function of intensity",
                .caption = caption_of(content)};
  if (content.has_suite) figure.description = headline(report);
  CurveDrawing drawing(report, figure);
  for (const auto& curve : report.curves) {
    std::visit([&drawing](const auto& reported) { drawing.add(reported); }, curve);
  }
  if (figure.panels.size() == 1) figure.subtitle = std::exchange(figure.panels.front().title, "");
  return figure;
}

}  // namespace rocking::analysis
