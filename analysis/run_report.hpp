#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/output/settling_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/write_report.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/quantile_interval.hpp"
#include "rocking/text/json.hpp"

/// A report in the form that figures and tables need: the numbers of report.json, unchanged.
namespace rocking::analysis {

struct ModeShare {
  std::uint64_t count = 0;
  double estimate = 0.0;
  stats::Interval interval;  ///< simultaneous; with `until` the anytime-valid one
};

/// The share of a mode that a condition may not list.
struct AnyShare {
  std::uint64_t count = 0;
  double estimate = 0.0;
  /// Absent if nothing is random, or if the report cannot contain one.
  std::optional<stats::Interval> interval;
};

struct Divergence {
  std::uint64_t pairs = 0;
  std::uint64_t diverged = 0;
  std::optional<double> lower_quartile, median, upper_quartile;  ///< [periods]; absent: beyond the horizon
};

struct Difference {
  double differ = 0.0;  ///< probability that two runs differ in response mode
  stats::Interval interval;
  double entropy = 0.0;  ///< [nat]
  Divergence by_friction, by_arithmetic;
};

/// Quantiles of a number over the realisations of a condition.
struct QuantileReport {
  std::uint64_t realisations = 0;
  std::uint64_t beyond = 0;  ///< realisations that count as above every value
  std::vector<stats::QuantileEstimate> levels;
  std::vector<stats::QuantileEstimate> levels_m;  ///< of a slip in metres; otherwise empty
};

/// Probability of having settled by each period at which its estimate changes; the lists have equal lengths.
struct IncidenceCurve {
  std::vector<double> periods;
  std::vector<double> estimate;
  std::vector<stats::Interval> pointwise;
  std::vector<stats::Interval> simultaneous;
};

/// Which response, and by when; of a run with `until_classified`.
struct IncidenceReport {
  std::map<section::ResponseMode, IncidenceCurve> modes;
  std::optional<IncidenceCurve> any_mode;  ///< absent in reports of earlier versions
  SettlingRow settling;                    ///< without its parameters and its limit
  std::vector<stats::QuantileEstimate> settling_periods;
  std::optional<stats::Interval> differ_interval;  ///< at the fixed horizon
  IncidenceCurve divergence;                       ///< of pairs with independent random numbers
  std::vector<stats::QuantileEstimate> divergence_periods;
};

struct ConditionReport {
  std::vector<Json> parameters;    ///< a value for each entry of the sweep
  std::optional<Shaking> shaking;  ///< absent under a ground motion, and in reports of earlier versions
  std::uint64_t realisations = 0;
  std::map<section::ResponseMode, ModeShare> modes;
  /// By the key of the report, `peak_tilt`, `peak_slip`, ...; those that it has.
  std::map<std::string, QuantileReport> quantiles;
  std::optional<Difference> difference;  ///< absent with fewer than two realisations
  std::optional<IncidenceReport> incidence = std::nullopt;
  bool stopped_by_data = false;  ///< `until` was requested
  bool is_random = true;         ///< otherwise the single realisation is the response, and intervals have no meaning
  double confidence = 0.95;
};

struct RunReport {
  std::string title;
  Json experiment;                 ///< canonical, as in `input.experiment`
  std::vector<std::string> swept;  ///< JSON pointers, in the order of the sweep
  std::vector<ConditionReport> conditions;
  Json text;  ///< the report without `internal`; of result.conditions only what pages describe in words

  /// Transient and sampled periods of a realisation; absent if they depend on the base motion and the block of each
  /// condition.
  [[nodiscard]] std::optional<std::uint64_t> periods() const;
  /// The confidence of the intervals, `95 %`; if it is swept, a text that says so.
  [[nodiscard]] std::string level() const;
  /// Response modes that occur in any condition, with their counts.
  [[nodiscard]] std::map<section::ResponseMode, std::uint64_t> occurring() const;
  /// Largest number of realisations of a condition.
  [[nodiscard]] std::uint64_t most_realisations() const;
  /// Response modes that any condition lists; some of them may not occur.
  [[nodiscard]] std::set<section::ResponseMode> listed() const;
  /// Whether any condition is random.
  [[nodiscard]] bool is_random() const;
};

/// A condition's row of the table of settling; absent unless the run has `until_classified`.
[[nodiscard]] std::optional<SettlingRow> settling_row(const RunReport& report, std::size_t condition);

/// The rows of the table of settling; empty unless the run has `until_classified`.
[[nodiscard]] std::vector<SettlingRow> settling_rows(const RunReport& report);

/// What to do if a fixed horizon is too short; empty if it is not.
[[nodiscard]] std::string unresolved_remedy(const RunReport& report);

/// Share of a mode in a condition. A condition does not list modes that did not occur in it; their interval is the one
/// that a report would have for a count of 0.
[[nodiscard]] AnyShare share_of(const ConditionReport& condition, const section::ResponseMode& mode);

/// The run report that reading the report.json of this run would give, without its text.
[[nodiscard]] RunReport run_report_of(const Experiment& experiment, const ExperimentResult& result,
                                      const SystemFacts& system);

/// The run report of a report in which problems_of_report finds no problem.
[[nodiscard]] RunReport run_report_of(Json report);

/// Reads and checks the text of a report.json. Throws base::InputError if it is no report or if its parts contradict
/// each other.
[[nodiscard]] RunReport read_run_report(std::string_view text);

}  // namespace rocking::analysis
