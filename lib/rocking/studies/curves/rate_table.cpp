#include "rocking/studies/curves/look.hpp"

#include <functional>

#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;

std::string range_table(const AnnualRate& rate, const std::string& measure) {
  look::Table table{.title = "\nannual rate by range of " + measure};
  add_columns(table, {measure + " from", "to", "per year", "share", "tested"});
  for (const RateInRange& range : rate.by_level) {
    table.rows.push_back({number(range.from, 3), number(range.to, 3), number(range.rate, look::rate_form()),
                          number(range.share, look::percentage()), range.is_tested ? "yes" : "no"});
  }
  return to_terminal(table);
}

/// What gives the rate below the least uplift: the fitted law, also where it is rejected, or the levels of one motion.
std::string_view impossible_source_in_words(RateSource source) {
  switch (source) {
    case RateSource::law: return "the law gives";
    case RateSource::levels: return "the interpolated levels give";
    case RateSource::isotonic: break;
  }
  return "the rejected law gives";
}

/// What the levels leave open, and what lies below the least uplift.
std::string extrapolation_text(const AnnualRate& rate, const CurveSubject& subject) {
  const std::string moves = subject.event.is_of_slip() ? "move" : "lift";
  const auto share = [&rate](double part) { return rate.value > 0.0 ? per_cent(part / rate.value) : "0.0"; };
  std::string text = "counted " + counted_from_in_words(subject) + why_counted_in_words(subject) + '\n' +
                     per_cent(rate.untested_share) + " % of the rate comes from intensities outside the levels";
  if (!subject.least_uplift) return text + '\n';
  text += ",\n" + share(rate.below_levels) + " % from those between the least and the lowest level that can " + moves +
          " the block\n";
  if (!(rate.impossible > 0.0)) return text;
  return text + "not counted: " + rate_text(rate.impossible) + " per year that " +
         std::string(impossible_source_in_words(rate.source)) + " below, where the block is not " + moves +
         (subject.event.is_of_slip() ? "d\n" : "ed\n");
}

std::string estimate_table(const SuiteRate& rate) {
  look::Table table{.title = "\nannual rate by the probabilities between the levels"};
  add_columns(table, {"rate by", "per year", "interval", "years"});
  for (const RateEstimate& estimate : rate.estimates) {
    table.rows.push_back({source_in_words(estimate.source, rate), number(estimate.value, look::rate_form()),
                          look::interval(estimate.interval, look::rate_form()),
                          estimate.value > 0.0 ? years_in_words(1.0 / estimate.value) : look::Cell()});
  }
  return to_terminal(table);
}

std::string record_share_text(const SuiteRate& rate) {
  constexpr std::size_t most_named = 3;
  std::vector<const RateOfRecord*> records;
  for (const RateOfRecord& record : rate.by_record) {
    if (record.rate > 0.0) records.push_back(&record);
  }
  if (records.empty()) return "";
  std::ranges::stable_sort(records, std::greater(), &RateOfRecord::share);
  std::string text = std::to_string(records.size()) + " of " + std::to_string(rate.by_record.size()) +
                     " records contribute; most of all";
  for (std::size_t i = 0; i < std::min(most_named, records.size()); ++i) {
    text += (i == 0 ? " " : ", ") + records[i]->name + ' ' + per_cent(records[i]->share) + " %";
  }
  return text + '\n';
}

std::string level_warnings(const SuiteRate& rate) {
  std::string text;
  if (!rate.do_estimates_agree()) {
    text += "warning: of the rates by law and by isotonic shares " + disagreement_in_words(rate) + "; add the levels " +
            added_levels_in_words(rate) + '\n';
  }
  if (!rate.is_decided()) {
    text += "warning: the levels leave " + undecided_in_words(rate) + " undecided; add " + added_levels_in_words(rate) +
            '\n';
  }
  return text;
}

}  // namespace

std::string disagreement_in_words(const SuiteRate& rate) {
  if (!rate.disagreement) return "one is 0 and the other is not";
  if (*rate.disagreement <= 1.0) return "the larger is " + per_cent(*rate.disagreement) + " % above the smaller";
  return "the larger is " + significant(1.0 + *rate.disagreement, 3) + " times the smaller";
}

std::string undecided_in_words(const SuiteRate& rate) {
  if (rate.undecided_share <= 1.0) return per_cent(rate.undecided_share) + " % of the rate";
  return "more than the whole rate";
}

std::string source_in_words(RateSource source) {
  switch (source) {
    case RateSource::law: return "law";
    case RateSource::levels: return "levels";
    case RateSource::isotonic: break;
  }
  return "isotonic shares";
}

std::string source_in_words(RateSource source, const SuiteRate& rate) {
  const bool is_rejected = source == RateSource::law && rate.chosen.source != RateSource::law;
  return (is_rejected ? "rejected " : "") + source_in_words(source);
}

std::string levels_in_words(const std::vector<double>& levels) {
  std::string text;
  for (const double level : levels) text += (text.empty() ? "" : ",") + significant(level, 6);
  return text;
}

std::string added_levels_in_words(const SuiteRate& rate) {
  const std::string text = levels_in_words(rate.add_levels);
  const std::optional<double>& end = rate.chosen.rare_below;
  if (!end || rate.add_levels.empty() || rate.add_levels.front() >= *end) return text;
  return text + " (those below " + significant(*end, 6) + " by `rocking rare`)";
}

/// How far the rare estimates give its probabilities, as a line; empty without any.
static std::string rare_use_in_words(const AnnualRate& rate) {
  if (!rate.rare_use) return "";
  const std::string end = rate.rare_below ? significant(*rate.rare_below, 6) : "";
  switch (*rate.rare_use) {
    case RareUse::below_sure_level: return "below " + end + " by the rare estimates\n";
    case RareUse::below_best_level:
      return "below " + end + " by the rare estimates, all of them, since no level has ten events; " + end +
             " has the most above them\n";
    case RareUse::up_to_highest:
      return "up to " + end +
             " by the rare estimates, all of them, since no level has ten events, and none above them has one\n";
    case RareUse::not_used: break;
  }
  return "the rare estimates are not used: none lies below the lowest level with ten events, or there is only one and "
         "no level above it has an event\n";
}

std::string rate_sources_in_words(const AnnualRate& rate, const CurveSubject& subject) {
  std::string text;
  for (const auto& [years, probability, interval] : rate.in_years) {
    text += "probability of " + words_of(subject.event) + " in " + base::shortest(years) +
            (years == 1.0 ? " year: " : " years: ") + in_years_text(probability) + " %" +
            (interval ? " [" + in_years_text(interval->low) + ", " + in_years_text(interval->high) + ']' : "") + '\n';
  }
  if (rate.source == RateSource::levels) {
    text +=
        "no function is fitted: the rate is that of the levels, interpolated; its interval assumes that the "
        "probability does not decrease\n";
  }
  if (!rate.interval) {
    text += rate.value > 0.0 ? "no interval of the rate: too few bootstrap samples over the records have a law\n"
                             : "no interval of the rate: it is too small for a double\n";
  }
  text += rare_use_in_words(rate);
  if (rate.source == RateSource::isotonic) {
    text += "no law holds, or not for every option: the rate is that of the isotonic shares\n";
  }
  return text;
}

std::string extrapolated_hazard_in_words(const AnnualRate& rate) {
  return per_cent(rate.extrapolated_hazard) + " % of the rate comes from beyond the last point of the hazard curve" +
         (rate.extrapolated_hazard > 0.0 ? "; without it: " + rate_text(rate.within_hazard) + " per year" : "");
}

std::vector<std::string> hazard_doubts(const AnnualRate& rate) {
  std::vector<std::string> doubts;
  if (rate.probability_at_first > 0.001) {
    doubts.push_back("at the lowest intensity of the hazard curve the probability is " +
                     per_cent(rate.probability_at_first) +
                     " %; weaker shaking is not counted: begin the hazard curve at lower intensities");
  }
  if (rate.frequent_hazard) {
    doubts.push_back("the hazard curve states " + significant(*rate.frequent_hazard, 3) +
                     " exceedances a year at its first intensity: check the kind and the unit of its columns");
  }
  if (rate.value > most_frequent_event) {
    doubts.push_back(
        "the event would happen " + rate_text(rate.value) +
        " times a year, as of no object that stands today: check the block, the units and the hazard curve");
  }
  return doubts;
}

std::vector<std::string> hazard_warnings(const AnnualRate& rate) {
  std::vector<std::string> warnings = hazard_doubts(rate);
  if (rate.extrapolated_hazard > most_extrapolated_hazard)
    warnings.push_back(extrapolated_hazard_in_words(rate) + "; continue the hazard curve");
  return warnings;
}

std::string annual_rate_warnings(const AnnualRate& rate) {
  std::string text;
  for (const std::string& warning : hazard_warnings(rate)) text += "warning: " + warning + '\n';
  return text;
}

std::string annual_rate_warnings(const SuiteRate& rate) {
  return annual_rate_warnings(rate.chosen) + level_warnings(rate);
}

std::string annual_rate_table(const SuiteRate& rate, const CurveSubject& subject, Extent extent) {
  return annual_rate_table(rate.chosen, subject, extent) + estimate_table(rate) + record_share_text(rate) +
         level_warnings(rate);
}

std::string annual_rate_table(const AnnualRate& rate, const CurveSubject& subject, Extent extent) {
  const std::string measure = last_key(subject.parameter);
  const bool is_extrapolated = rate.extrapolated_hazard > most_extrapolated_hazard;
  return (extent == Extent::all ? range_table(rate, measure) : "\n") + extrapolation_text(rate, subject) +
         (is_extrapolated ? "" : extrapolated_hazard_in_words(rate) + '\n') + annual_rate_warnings(rate);
}

std::string hazard_in_words(const HazardCurve& hazard) {
  const std::string kind =
      hazard.years ? "probabilities of exceedance in " + significant(*hazard.years, 6) + " years" : "annual rates";
  std::string text = kind + " of " + hazard.intensity + " at " + std::to_string(hazard.points.size()) +
                     " points from " + significant(hazard.points.front().intensity, 3) + " to " +
                     significant(hazard.points.back().intensity, 3);
  if (!hazard.statistic.empty()) text += ", " + hazard.statistic;
  if (hazard.site)
    text += ", site " + base::shortest(hazard.site->longitude) + ',' + base::shortest(hazard.site->latitude);
  if (hazard.certain == 0) return text;
  return text + "; left out: " + std::to_string(hazard.certain) + " weaker with the probability 1";
}

}  // namespace rocking
