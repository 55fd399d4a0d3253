#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/report/json.hpp"
#include "rocking/report/write_report.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"

/// A report as figures and tables need it: the numbers of report.json, as they stand there.
namespace rocking::analysis {

struct ModeShare {
  std::uint64_t count = 0;
  double estimate = 0.0;
  stats::Interval interval;  ///< simultaneous; with `until` the one that holds whenever the run stopped
};

/// The same of a mode that a condition may not list.
struct AnyShare {
  std::uint64_t count = 0;
  double estimate = 0.0;
  std::optional<stats::Interval> interval;  ///< absent where a report cannot have one
};

struct Parting {
  std::uint64_t pairs = 0;
  std::uint64_t parted = 0;
  std::optional<double> lower_quartile, median, upper_quartile;  ///< [periods]; absent: beyond the horizon
};

struct Difference {
  double differ = 0.0;  ///< probability that two runs differ in response mode
  stats::Interval interval;
  double entropy = 0.0;  ///< [nat]
  Parting by_friction, by_arithmetic;
};

struct ConditionReport {
  std::vector<report::Json> parameters;  ///< a value for each entry of the sweep
  std::uint64_t realisations = 0;
  std::map<section::ResponseMode, ModeShare> modes;
  std::optional<Difference> difference;  ///< absent with fewer than two realisations
  bool stopped_by_data = false;          ///< `until` was asked for
  double confidence = 0.95;
};

struct RunReport {
  std::string title;
  report::Json experiment;         ///< canonical, as in `input.experiment`
  std::vector<std::string> swept;  ///< JSON pointers, in the order of the sweep
  std::vector<ConditionReport> conditions;
  report::Json text;  ///< the report without `internal`; of result.conditions only what a page tells in words

  /// Periods of a realisation, dropped and sampled; absent where a record and each condition's block decide.
  [[nodiscard]] std::optional<std::uint64_t> periods() const;
  /// The confidence of the intervals, `95 %`; where a sweep changes it, the words that say so.
  [[nodiscard]] std::string level() const;
  /// Response modes that occur anywhere, with how often.
  [[nodiscard]] std::map<section::ResponseMode, std::uint64_t> occurring() const;
};

/// What a condition says of a mode. Of one that it does not list, since it never occurred there, the interval is the one
/// that the report of such a mode would have.
[[nodiscard]] AnyShare share_of(const ConditionReport& condition, const section::ResponseMode& mode);

/// What reading a run's report.json would give, without its text.
[[nodiscard]] RunReport run_report_of(const experiment::Experiment& experiment,
                                      const experiment::ExperimentResult& result, const report::SystemFacts& system);

/// What figures and tables need of a report in which report::problems_of_report finds no problem.
[[nodiscard]] RunReport run_report_of(report::Json report);

/// Reads the text of a report.json and checks it. Throws base::InputError where it is none, or its parts contradict each
/// other.
[[nodiscard]] RunReport read_run_report(std::string_view text);

}  // namespace rocking::analysis
