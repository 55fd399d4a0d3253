#include <array>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "rocking/output/parameter_text.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

using look::number;
using look::percentage;

/// The columns that say which curve a row is of, where there are several.
struct Heads {
  std::set<std::string> parameters;
  bool has_names = false;
  bool has_events = false;

  explicit Heads(const FragilityReport& report) {
    std::set<std::string> names, events;
    for (const auto& curve : report.curves) {
      std::visit(
          [&](const auto& reported) {
            names.insert(name_of_curve(reported));
            events.insert(column_of(reported.curve.subject.event));
            parameters.insert(last_key(reported.curve.subject.parameter));
          },
          curve);
    }
    has_names = names.size() > 1;
    has_events = events.size() > 1;
  }

  template <class Reported>
  static std::string name_of_curve(const Reported& reported) {
    const std::string values = values_of(reported.curve.subject.others);
    return reported.run.title + (reported.run.title.empty() || values.empty() ? "" : ", ") + values;
  }

  [[nodiscard]] look::Table table() const {
    look::Table table;
    if (has_names) add_columns(table, {"curve"});
    if (has_events) add_columns(table, {"event"});
    return table;
  }
  template <class Reported>
  [[nodiscard]] look::Row row(const Reported& reported, const look::Row& cells) const {
    look::Row row;
    if (has_names) row.emplace_back(name_of_curve(reported));
    if (has_events) row.emplace_back(column_of(reported.curve.subject.event));
    append(row, cells);
    return row;
  }
};

std::string title_of(const FragilityReport& report) {
  return report.curves.empty() ? ""
                               : std::visit([](const auto& reported) { return reported.run.title; }, report.curves[0]);
}

/// Nothing without a value.
look::Cell share_with(const std::optional<double>& value, const std::optional<stats::Interval>& interval) {
  return value ? number(*value, interval, percentage()) : look::Cell();
}

look::Row cells_of(const FragilityLevel& level) {
  return {look::whole(level.overturned.trials), look::whole(level.overturned.successes),
          number(level.estimate, level.exact, percentage()),
          share_with(level.fitted, level.isotonic ? std::nullopt : level.band), share_with(level.isotonic, level.band)};
}

look::Row cells_of(const SuiteLevel& level) {
  return {look::whole(level.overturned.trials), look::whole(level.overturned.successes),
          number(level.estimate, std::optional<stats::Interval>(), percentage()), share_with(level.fitted, level.band),
          share_with(level.isotonic, level.isotonic_band)};
}

StudyTable table_of_levels(const FragilityReport& report) {
  const Heads heads(report);
  look::Table table = heads.table();
  add_columns(table, {heads.parameters.size() == 1 ? *heads.parameters.begin() : "intensity"});
  table.columns.push_back({.title = "n", .latex = "$n$"});
  table.columns.push_back({.title = "count", .latex = "$k$"});
  for (const char* title : {"share", "fitted", "isotonic"}) {
    table.columns.push_back({.title = title, .latex = {}, .html = {}, .has_interval = true});
  }
  for (const auto& curve : report.curves) {
    std::visit(
        [&](const auto& reported) {
          for (const auto& level : reported.curve.levels) {
            look::Row row{number(level.intensity, 6)};
            append(row, cells_of(level));
            table.rows.push_back(heads.row(reported, row));
          }
        },
        curve);
  }
  return {
      .name = "fragility_levels",
      .table = table,
      .caption = look::latex_caption(title_of(report),
                                     "$k$ of $n$ realisations have the event; share of them (of a suite the mean over "
                                     "its records), fitted and isotonic probability, in per cent with intervals.")};
}

/// Value and interval of the median and of the dispersion, if there is a law.
std::optional<std::array<stats::Bounded, 2>> law_of(const FragilityCurve& curve) {
  if (!curve.law) return std::nullopt;
  return std::array{curve.law->median, curve.law->dispersion};
}

std::optional<std::array<stats::Bounded, 2>> law_of(const SuiteCurve& curve) {
  if (!curve.pooled) return std::nullopt;
  const PooledSuite& pooled = *curve.pooled;
  return std::array{stats::Bounded{pooled.median.value, pooled.median.interval},
                    stats::Bounded{pooled.dispersion.value, pooled.dispersion.interval}};
}

StudyTable table_of_curves(const FragilityReport& report) {
  const Heads heads(report);
  look::Table table = heads.table();
  add_columns(table, {"outcome"});
  for (const char* title : {"median", "dispersion", "per_year"}) {
    table.columns.push_back({.title = title, .latex = {}, .html = {}, .has_interval = true});
  }
  table.columns.back().latex = "per year";
  for (const auto& curve : report.curves) {
    std::visit(
        [&](const auto& reported) {
          look::Row row{std::string(to_string(reported.curve.outcome)), {}, {}, {}};
          if (const auto law = law_of(reported.curve)) {
            row[1] = number((*law)[0].value, (*law)[0].interval, 3);
            row[2] = number((*law)[1].value, (*law)[1].interval, 3);
          }
          if (const AnnualRate* rate = rate_of(reported))
            row[3] = number(rate->value, rate->interval, look::rate_form());
          table.rows.push_back(heads.row(reported, row));
        },
        curve);
  }
  return {.name = "fragility_curves",
          .table = table,
          .caption = look::latex_caption(title_of(report),
                                         "Lognormal law of the capacity, and mean annual rate, with intervals.")};
}

}  // namespace

std::vector<StudyTable> fragility_tables(const FragilityReport& report) {
  return {table_of_levels(report), table_of_curves(report)};
}

}  // namespace rocking
